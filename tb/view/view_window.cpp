// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/view_window.h"

#include <SDL.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <set>

#include "sc/constants.h"
#include "tb/console.h"
#include "tb/errors.h"
#include "tb/view/frame_sound.h"

namespace racebeam {

namespace {

constexpr int LongestQueue = FrameSound::Rate / 4;  // samples that wait to be played
constexpr int MostScale = 3;

// "keypad +" is "+" too.
std::string key_name(const SDL_Keysym& key) {
  std::string name = SDL_GetKeyName(key.sym);
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name.rfind("keypad ", 0) == 0 ? name.substr(7) : name;
}

// Keys that go on while they are held.
bool repeats(const std::string& key) {
  static const std::set<std::string> keys{".", "l", "k", "c", "left", "right", "=", "+", "-"};
  return keys.count(key) > 0;
}

class Window : public ViewScreen {
 public:
  explicit Window(int scale) {
    SDL_SetMainReady();
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "nearest");
    if (SDL_Init(SDL_INIT_VIDEO) != 0) fail("no window can be opened");
    if (unseen() && !driver_asked_for()) {
      SDL_SetError("there is no display");
      fail("no window can be opened");
    }
    SDL_EnableScreenSaver();
    scale_ = scale > 0 ? scale : best_scale();
    window_ = SDL_CreateWindow("racebeam", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                               VisibleColumns * scale_, VisibleRows * scale_, SDL_WINDOW_RESIZABLE);
    if (!window_) fail("no window can be opened");
    renderer_ = SDL_CreateRenderer(window_, -1, 0);
    if (!renderer_) renderer_ = SDL_CreateRenderer(window_, -1, SDL_RENDERER_SOFTWARE);
    if (!renderer_) fail("nothing can be drawn in a window");
    open_sound();
  }
  ~Window() override {
    if (sound_) SDL_CloseAudioDevice(sound_);
    if (texture_) SDL_DestroyTexture(texture_);
    if (renderer_) SDL_DestroyRenderer(renderer_);
    if (window_) SDL_DestroyWindow(window_);
    SDL_Quit();
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  bool poll(ViewControl& control) override;
  void show(const Viewer& viewer) override;
  void play(const std::vector<float>& samples) override;

 private:
  [[noreturn]] static void fail(const char* what) {
    const std::string reason = SDL_GetError();
    SDL_Quit();
    throw MissingTool(std::string(what) + ": " + reason +
                      "; set DISPLAY, or watch in the terminal: racebeam view --term");
  }
  // Without a display SDL may take a driver that draws into memory.
  static bool unseen() {
    const std::string driver = SDL_GetCurrentVideoDriver();
    return driver == "offscreen" || driver == "dummy";
  }
  static bool driver_asked_for() {
    const char* driver = std::getenv("SDL_VIDEODRIVER");
    return driver != nullptr && *driver != '\0';
  }
  static int best_scale() {
    SDL_Rect desk;
    if (SDL_GetDisplayUsableBounds(0, &desk) != 0) return 1;
    return std::clamp(std::min(desk.w * 4 / 5 / VisibleColumns, desk.h * 4 / 5 / VisibleRows), 1,
                      MostScale);
  }
  void open_sound();
  void resize(const RgbImage& picture);

  SDL_Window* window_ = nullptr;
  SDL_Renderer* renderer_ = nullptr;
  SDL_Texture* texture_ = nullptr;
  SDL_AudioDeviceID sound_ = 0;
  int scale_ = 1, width_ = 0, height_ = 0;  // of the texture
  bool full_screen_ = false;
};

void Window::open_sound() {
  SDL_AudioSpec wish{};
  wish.freq = FrameSound::Rate;
  wish.format = AUDIO_F32SYS;
  wish.channels = 1;
  wish.samples = 1024;
  if (SDL_InitSubSystem(SDL_INIT_AUDIO) == 0)
    sound_ = SDL_OpenAudioDevice(nullptr, 0, &wish, nullptr, 0);
  if (sound_) SDL_PauseAudioDevice(sound_, 0);
  else tell(std::string("no sound: ") + SDL_GetError());
}

bool Window::poll(ViewControl& control) {
  const bool flying = control.state.flying;
  if ((SDL_GetRelativeMouseMode() == SDL_TRUE) != flying)
    SDL_SetRelativeMouseMode(flying ? SDL_TRUE : SDL_FALSE);
  bool stale = false;
  for (SDL_Event event; SDL_PollEvent(&event);) {
    if (event.type == SDL_QUIT) control.press("escape");
    if (event.type == SDL_KEYUP) control.release(key_name(event.key.keysym));
    if (event.type == SDL_MOUSEMOTION) control.mouse(event.motion.xrel, event.motion.yrel);
    if (event.type == SDL_WINDOWEVENT) {
      stale = true;
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) control.release_all();
    }
    if (event.type != SDL_KEYDOWN) continue;
    const std::string key = key_name(event.key.keysym);
    if (event.key.repeat == 0 || repeats(key)) stale |= control.press(key);
  }
  if (control.state.full_screen != full_screen_) {
    full_screen_ = control.state.full_screen;
    SDL_SetWindowFullscreen(window_, full_screen_ ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
  }
  return stale;
}

// The window takes the picture's size; one that the user has made otherwise keeps its scale.
void Window::resize(const RgbImage& picture) {
  if (texture_) SDL_DestroyTexture(texture_);
  texture_ = SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_RGB24, SDL_TEXTUREACCESS_STREAMING,
                               picture.width(), picture.height());
  if (!texture_) fail("nothing can be drawn in a window");
  if (width_ > 0 && !full_screen_) {
    int width = 0, height = 0;
    SDL_GetWindowSize(window_, &width, &height);
    SDL_SetWindowSize(window_, width * picture.width() / width_,
                      height * picture.height() / height_);
  }
  width_ = picture.width();
  height_ = picture.height();
  SDL_RenderSetLogicalSize(renderer_, width_, height_);
}

void Window::show(const Viewer& viewer) {
  const RgbImage picture = viewer.picture();
  SDL_SetWindowTitle(window_, viewer.title().c_str());
  if (picture.width() != width_ || picture.height() != height_) resize(picture);
  SDL_UpdateTexture(texture_, nullptr, picture.bytes(), 3 * picture.width());
  SDL_SetRenderDrawColor(renderer_, 0, 0, 0, 255);
  SDL_RenderClear(renderer_);
  SDL_RenderCopy(renderer_, texture_, nullptr, nullptr);
  SDL_RenderPresent(renderer_);
}

void Window::play(const std::vector<float>& samples) {
  if (!sound_ || samples.empty()) return;
  if (SDL_GetQueuedAudioSize(sound_) > LongestQueue * sizeof(float)) return;
  SDL_QueueAudio(sound_, samples.data(), static_cast<Uint32>(samples.size() * sizeof(float)));
}

}  // namespace

std::unique_ptr<ViewScreen> open_window(int scale) { return std::make_unique<Window>(scale); }

}  // namespace racebeam
