// libracebeam_window.so: the one file of the program that knows SDL2.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <SDL.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <set>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include "sc/base/constants.h"
#include "tb/base/errors.h"
#include "tb/view/window_library.h"

namespace racebeam {

namespace {

// "keypad +" is "+" too.
std::string key_name(const SDL_Keysym& key) {
  std::string name = SDL_GetKeyName(key.sym);
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name.rfind("keypad ", 0) == 0 ? name.substr(7) : name;
}

// Keys that go on while they are held.
bool repeats(const std::string& key) {
  static const std::set<std::string> keys{".", "l", "j", "k", "c", "left", "right", "=", "+", "-"};
  return keys.count(key) > 0;
}

struct Pixel {
  int column, row;
};

class SdlWindow : public LibraryWindow {
 public:
  SdlWindow(int scale, int sound_rate, void (*tell)(std::string_view))
      : tell_(tell), sound_rate_(sound_rate), wish_(scale) {
#ifdef __SANITIZE_ADDRESS__
    __lsan_disable();  // of a program with a window: what SDL's libraries keep is theirs
#endif
    SDL_SetMainReady();
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "nearest");
    const bool asked_for = driver_asked_for();
    if (!asked_for)  // an empty SDL_VIDEODRIVER too
      SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, drivers_of_displays().c_str(),
                              SDL_HINT_OVERRIDE);
    if (SDL_Init(SDL_INIT_VIDEO) != 0) {
      if (!asked_for) SDL_SetError("there is no display");
      fail("no window can be opened");
    }
    SDL_EnableScreenSaver();
    own_ = scaled(picture_, scale_in(window_room(screen_at(0).size)));
    window_ = SDL_CreateWindow("racebeam", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                               own_.width, own_.height, SDL_WINDOW_RESIZABLE);
    if (!window_) fail("no window can be opened");
    renderer_ = SDL_CreateRenderer(window_, -1, 0);
    if (!renderer_) renderer_ = SDL_CreateRenderer(window_, -1, SDL_RENDERER_SOFTWARE);
    if (!renderer_) fail("nothing can be drawn in a window");
    open_sound();
  }
  ~SdlWindow() override {
    if (sound_) SDL_CloseAudioDevice(sound_);
    if (larger_) SDL_DestroyTexture(larger_);
    if (texture_) SDL_DestroyTexture(texture_);
    if (renderer_) SDL_DestroyRenderer(renderer_);
    if (window_) SDL_DestroyWindow(window_);
    SDL_Quit();
  }
  SdlWindow(const SdlWindow&) = delete;
  SdlWindow& operator=(const SdlWindow&) = delete;

  void keep_mouse(bool kept) override;
  void fill_screen(bool filled) override;
  bool poll(UserInput& user) override;
  void show(const std::uint8_t* rgb, Extent picture, Extent chip,
            const std::string& title) override;
  void play(const std::vector<float>& samples) override;

 private:
  [[noreturn]] static void fail(const char* what) {
    const std::string reason = SDL_GetError();
    SDL_Quit();
    throw MissingTool(std::string(what) + ": " + reason +
                      "; set DISPLAY, or watch in the terminal: racebeam view --term");
  }
  static bool driver_asked_for() {
    const char* driver = std::getenv("SDL_VIDEODRIVER");
    return driver != nullptr && *driver != '\0';
  }
  // All that SDL has, but for those that draw into memory, and Wayland where it would only complain
  // of the folder that it has not got.
  static std::string drivers_of_displays() {
    const char* folder = std::getenv("XDG_RUNTIME_DIR");
    const bool wayland = folder != nullptr && *folder == '/';
    std::string list;
    for (int i = 0; i < SDL_GetNumVideoDrivers(); ++i) {
      const std::string name = SDL_GetVideoDriver(i);
      if (name == "offscreen" || name == "dummy" || name == "evdev") continue;
      if (name == "wayland" && !wayland) continue;
      list += (list.empty() ? "" : ",") + name;
    }
    return list;
  }
  // The part of a display that is no bar.
  static Box screen_at(int display) {
    SDL_Rect screen;
    if (SDL_GetDisplayUsableBounds(display, &screen) != 0) return {0, 0, {1024, 768}};
    return {screen.x, screen.y, {screen.w, screen.h}};
  }
  // As the user wished, if it fits.
  double scale_in(Extent room) const {
    const double fit = fit_scale(picture_, room);
    return wish_ > 0 ? std::min(wish_, fit) : fit;
  }
  Extent window_size() const {
    Extent size;
    SDL_GetWindowSize(window_, &size.width, &size.height);
    return size;
  }
  // Its size is not the window's own affair.
  bool is_given_its_size() const {
    return (SDL_GetWindowFlags(window_) & (SDL_WINDOW_FULLSCREEN_DESKTOP | SDL_WINDOW_MAXIMIZED)) !=
           0;
  }
  void open_sound();
  void take_picture_size(Extent size);
  void fit_window();
  void draw(Extent window);
  Pixel pixel_at(int x, int y) const;

  void (*const tell_)(std::string_view);
  const int sound_rate_;
  SDL_Window* window_ = nullptr;
  SDL_Renderer* renderer_ = nullptr;
  SDL_Texture *texture_ = nullptr,
              *larger_ = nullptr;  // the picture; a whole number times as large
  SDL_AudioDeviceID sound_ = 0;
  double wish_;  // size of a pixel that the user wants; 0: as large as fits
  Extent picture_{VisibleColumns, VisibleRows}, own_;  // own: of the window, as it was made here
  Extent fitted_ = picture_;                           // the picture for which that was
  Extent larger_size_;
  Extent chip_ = picture_;  // its own part of the picture
  bool full_screen_ = false;
};

void SdlWindow::open_sound() {
  SDL_AudioSpec wish{};
  wish.freq = sound_rate_;
  wish.format = AUDIO_F32SYS;
  wish.channels = 1;
  wish.samples = 1024;
  if (SDL_InitSubSystem(SDL_INIT_AUDIO) == 0)
    sound_ = SDL_OpenAudioDevice(nullptr, 0, &wish, nullptr, 0);
  if (sound_) SDL_PauseAudioDevice(sound_, 0);
  else tell_(std::string("no sound: ") + SDL_GetError());
}

void SdlWindow::keep_mouse(bool kept) {
  if ((SDL_GetRelativeMouseMode() == SDL_TRUE) != kept)
    SDL_SetRelativeMouseMode(kept ? SDL_TRUE : SDL_FALSE);
}

void SdlWindow::fill_screen(bool filled) {
  if (filled == full_screen_) return;
  full_screen_ = filled;
  SDL_SetWindowFullscreen(window_, filled ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
}

bool SdlWindow::poll(UserInput& user) {
  bool stale = false;
  for (SDL_Event event; SDL_PollEvent(&event);) {
    if (event.type == SDL_QUIT) user.press("escape");
    if (event.type == SDL_KEYUP) user.release(key_name(event.key.keysym));
    if (event.type == SDL_MOUSEMOTION) user.mouse(event.motion.xrel, event.motion.yrel);
    if (event.type == SDL_MOUSEBUTTONDOWN && event.button.button == SDL_BUTTON_LEFT) {
      const auto [column, row] = pixel_at(event.button.x, event.button.y);
      if (column >= 0 && row >= 0 && column < chip_.width && row < chip_.height)
        user.click(column, row);
    }
    if (event.type == SDL_AUDIODEVICEREMOVED && sound_ && event.adevice.which == sound_) {
      SDL_CloseAudioDevice(sound_);
      sound_ = 0;
      tell_("no sound: the loudspeaker is gone");
    }
    if (event.type == SDL_WINDOWEVENT) {
      stale = true;
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) user.release_all();
    }
    if (event.type != SDL_KEYDOWN) continue;
    const std::string key = key_name(event.key.keysym);
    if (event.key.repeat == 0 || repeats(key)) stale |= user.press(key);
  }
  return stale;
}

void SdlWindow::take_picture_size(Extent size) {
  if (texture_) SDL_DestroyTexture(texture_);
  texture_ = SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_RGB24, SDL_TEXTUREACCESS_STREAMING,
                               size.width, size.height);
  if (!texture_) fail("nothing can be drawn in a window");
  picture_ = size;
}

// The window takes the picture's size, wholly on its screen. One that the user has made larger or
// smaller keeps the size of a pixel.
void SdlWindow::fit_window() {
  if (const Extent now = window_size(); now != own_) wish_ = fit_scale(fitted_, now);
  const Box screen = screen_at(std::max(SDL_GetWindowDisplayIndex(window_), 0));
  own_ = scaled(picture_, scale_in(window_room(screen.size)));
  fitted_ = picture_;
  SDL_SetWindowSize(window_, own_.width, own_.height);
  int above = 0, left = 0, below = 0, right = 0, x = 0, y = 0;
  SDL_GetWindowBordersSize(window_, &above, &left, &below, &right);
  SDL_GetWindowPosition(window_, &x, &y);
  const Box whole{x - left, y - above, {own_.width + left + right, own_.height + above + below}};
  const Box place = kept_within(whole, screen);
  if (place.left != whole.left || place.top != whole.top)
    SDL_SetWindowPosition(window_, place.left + left, place.top + above);
}

// Between two whole scales the next larger one is made smaller: pixels stay even, edges sharp.
void SdlWindow::draw(Extent window) {
  const Box box = picture_in(picture_, window);
  const SDL_Rect place{box.left, box.top, box.size.width, box.size.height};
  const int times = (box.size.width + picture_.width - 1) / picture_.width;
  const Extent large = scaled(picture_, times);
  if (box.size != large && large != larger_size_) {
    if (larger_) SDL_DestroyTexture(larger_);
    larger_ = SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_RGB24, SDL_TEXTUREACCESS_TARGET,
                                large.width, large.height);
    if (larger_) SDL_SetTextureScaleMode(larger_, SDL_ScaleModeLinear);
    larger_size_ = large;
  }
  const bool smooth = box.size != large && larger_;
  if (smooth) {
    SDL_SetRenderTarget(renderer_, larger_);
    SDL_RenderCopy(renderer_, texture_, nullptr, nullptr);
    SDL_SetRenderTarget(renderer_, nullptr);
  }
  SDL_SetRenderDrawColor(renderer_, 0, 0, 0, 255);
  SDL_RenderClear(renderer_);
  SDL_RenderCopy(renderer_, smooth ? larger_ : texture_, nullptr, &place);
  SDL_RenderPresent(renderer_);
}

void SdlWindow::show(const std::uint8_t* rgb, Extent picture, Extent chip,
                     const std::string& title) {
  SDL_SetWindowTitle(window_, title.c_str());
  chip_ = chip;
  if (!texture_ || picture != picture_) take_picture_size(picture);
  if (fitted_ != picture_ && !is_given_its_size()) fit_window();
  SDL_UpdateTexture(texture_, nullptr, rgb, 3 * picture.width);
  Extent window;
  if (SDL_GetRendererOutputSize(renderer_, &window.width, &window.height) == 0) draw(window);
}

// Outside of the chip's picture too.
Pixel SdlWindow::pixel_at(int x, int y) const {
  const Box box = picture_in(picture_, window_size());
  const double scale = static_cast<double>(box.size.width) / picture_.width;
  return {static_cast<int>(std::floor((x - box.left) / scale)),
          static_cast<int>(std::floor((y - box.top) / scale))};
}

void SdlWindow::play(const std::vector<float>& samples) {
  if (!sound_ || samples.empty()) return;
  const int longest_queue = sound_rate_ / 4;  // samples that wait to be played
  if (SDL_GetQueuedAudioSize(sound_) > longest_queue * sizeof(float)) return;
  SDL_QueueAudio(sound_, samples.data(), static_cast<Uint32>(samples.size() * sizeof(float)));
}

std::string version() {
  SDL_version linked;
  SDL_GetVersion(&linked);
  return std::to_string(linked.major) + "." + std::to_string(linked.minor) + "." +
         std::to_string(linked.patch);
}

std::unique_ptr<LibraryWindow> open(int scale, int sound_rate, void (*tell)(std::string_view)) {
  return std::make_unique<SdlWindow>(scale, sound_rate, tell);
}

}  // namespace
}  // namespace racebeam

extern "C" {
extern const racebeam::WindowLibrary racebeam_window_library;
const racebeam::WindowLibrary racebeam_window_library = {racebeam::version, racebeam::open};
}
