// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/verilog_bench.h"

#include <fmt/format.h>

#include <utility>

namespace racebeam {

namespace {

using Port = PortTraffic::Port;

std::string range(int bits) { return bits == 1 ? "" : fmt::format("[{}:0] ", bits - 1); }

/// A literal of several values side by side, the first one highest.
class Literal {
 public:
  void add(std::uint64_t value, int bits) {
    for (int bit = bits - 1; bit >= 0; --bit) bits_ += value >> bit & 1 ? '1' : '0';
  }
  std::string text() const {
    std::string hex;
    for (std::size_t end = bits_.size(); end > 0; end -= std::min<std::size_t>(end, 4)) {
      const std::size_t begin = end - std::min<std::size_t>(end, 4);
      hex.insert(hex.begin(),
                 "0123456789abcdef"[std::stoi(bits_.substr(begin, end - begin), nullptr, 2)]);
    }
    return fmt::format("{}'h{}", bits_.size(), hex);
  }

 private:
  std::string bits_;
};

class Writer {
 public:
  explicit Writer(const VerilogBench& bench) : bench_(bench), traffic_(bench.traffic) {
    for (std::size_t n = 0; n < traffic_.ports.size(); ++n)
      (traffic_.ports[n].input ? inputs_ : outputs_).push_back(n);
  }

  std::string text() {
    head();
    declarations();
    instance();
    table();
    tasks();
    run();
    return std::move(text_) + "endmodule\n";
  }

 private:
  void line(const std::string& text) { text_ += text + "\n"; }
  const Port& port(std::size_t number) const { return traffic_.ports[number]; }
  int bits_of(const std::vector<std::size_t>& ports) const {
    int bits = 0;
    for (const std::size_t n : ports) bits += port(n).bits;
    return bits;
  }
  std::string names(const std::vector<std::size_t>& ports, const std::string& before = "") const {
    std::string text;
    for (const std::size_t n : ports) text += (text.empty() ? "" : ", ") + before + port(n).name;
    return "{" + text + "}";
  }
  bool masked() const { return !bench_.unknown.empty(); }

  void head() {
    const std::string& unit = traffic_.unit;
    for (const std::string& comment : bench_.comment) line("// " + comment);
    line(fmt::format(
        "//   $ iverilog -g2001{1} -o {0}_bench {0}_bench.v NETLIST.v && vvp -N {0}_bench", unit,
        bench_.deposits.empty() ? "" : " -DDEPOSIT"));
    line(fmt::format(
        "//   $ verilator --binary --timing --top-module {0}_bench {0}_bench.v RTL.sv ...", unit));
    line("module " + unit + "_bench;");
  }

  void declarations() {
    if (bench_.clocked) line("  reg clk_i;");
    for (const std::size_t n : inputs_) line("  reg " + range(port(n).bits) + port(n).name + ";");
    for (const std::size_t n : outputs_) {
      line("  wire " + range(port(n).bits) + port(n).name + ";");
      line("  reg " + range(port(n).bits) + "want_" + port(n).name + ";");
      if (masked()) line("  reg skip_" + port(n).name + ";");
    }
    line("  integer clock, step;");
    line("");
  }

  void instance() {
    std::string parameters, ports;
    for (const std::string& one : bench_.parameters) {
      const auto equals = one.find('=');
      parameters += fmt::format("{}.{}({})", parameters.empty() ? "" : ", ", one.substr(0, equals),
                                one.substr(equals + 1));
    }
    if (bench_.clocked) ports = ".clk_i(clk_i)";
    for (const Port& one : traffic_.ports)
      ports += fmt::format("{}\n    .{}({})", ports.empty() ? "" : ",", one.name, one.name);
    if (parameters.empty()) {
      line("  " + traffic_.unit + " dut (" + ports + ");");
    } else {
      line("  " + traffic_.unit);
      line("`ifndef NETLIST  // define it for a netlist: that has no parameters");
      line("    #(" + parameters + ")");
      line("`endif");
      line("    dut (" + ports + ");");
    }
    line("");
  }

  /// All clocks, one a row: inputs, outputs, bits not to be compared.
  void table() {
    const auto rows = [&](const std::string& name, int bits, const auto& add) {
      line(fmt::format("  reg [{}:0] {} [0:{}];", bits - 1, name, traffic_.clocks() - 1));
      line("  initial begin");
      for (std::uint64_t clock = 0; clock < traffic_.clocks(); ++clock) {
        Literal literal;
        add(literal, clock * traffic_.ports.size());
        line(fmt::format("    {}[{}] = {};", name, clock, literal.text()));
      }
      line("  end");
    };
    const auto values = [&](const std::vector<std::size_t>& ports) {
      return [&](Literal& literal, std::size_t row) {
        for (const std::size_t n : ports) literal.add(traffic_.values[row + n], port(n).bits);
      };
    };
    line("  // Clock by clock: " + names(inputs_));
    rows("drive", bits_of(inputs_), values(inputs_));
    line("  // What must be there: " + names(outputs_));
    rows("want", bits_of(outputs_), values(outputs_));
    if (masked()) {
      line("  // 1: what registers have at power-up is still there, and nothing is compared");
      rows("skip", static_cast<int>(outputs_.size()), [&](Literal& literal, std::size_t row) {
        for (const std::size_t n : outputs_) literal.add(bench_.unknown[row + n], 1);
      });
    }
    line("");
  }

  void tasks() {
    line("  task edges(input integer count);");
    line("    for (step = 0; step < count; step = step + 1) begin");
    line(bench_.clocked ? "      #1 clk_i = 1'b1;\n      #1 clk_i = 1'b0;" : "      #2;");
    line("    end");
    line("  endtask");
    line("");
    line("  // All outputs in one clock; the first that is wrong ends the run.");
    line("  task compare;");
    line("    begin");
    line("      " + names(outputs_, "want_") + " = want[clock];");
    if (masked()) line("      " + names(outputs_, "skip_") + " = skip[clock];");
    std::string before = "      ";
    for (const std::size_t n : outputs_) {
      const std::string& name = port(n).name;
      line(before + (masked() ? fmt::format("if (!skip_{0} && {0} !== want_{0})", name)
                              : fmt::format("if ({0} !== want_{0})", name)));
      line(fmt::format("        fail(\"{0}\", {1}want_{0}{2}, {1}{0}{2});", name,
                       port(n).bits == 64 ? "" : fmt::format("{{{}'d0, ", 64 - port(n).bits),
                       port(n).bits == 64 ? "" : "}"));
      before = "      else ";
    }
    line("    end");
    line("  endtask");
    line("");
    line("  task fail(input [511:0] port, input [63:0] expected, input [63:0] got);");
    line("    begin");
    line(
        "      $display(\"FAIL: port %0s, clock %0d: expected %0h, got %0h\", port, clock, "
        "expected, got);");
    line("      $stop;");
    line("    end");
    line("  endtask");
    line("");
  }

  void seeks() {
    if (bench_.seeks.empty()) return;
    line("      // The counter of frames goes to another one: through a reset, counting.");
    line("      case (clock)");
    for (const auto& [clock, frame] : bench_.seeks) {
      line(fmt::format("        {}: begin", clock));
      line("          rst_ni = 1'b0;\n          edges(1);\n          rst_ni = 1'b1;");
      line(fmt::format("          frame_end_i = 1'b1;\n          edges({});\n        end", frame));
    }
    line("        default: ;");
    line("      endcase");
  }

  void deposits() {
    if (bench_.deposits.empty()) return;
    line(
        "`ifdef DEPOSIT  // registers without reset, for four states: no value makes a difference");
    line("      if (clock == 0) begin");
    for (const VerilogBench::Deposit& one : bench_.deposits)
      line(fmt::format("        dut.{} = {}'h{:x};", one.name, one.bits, one.value));
    line("      end");
    line("`endif");
  }

  void run() {
    line("  initial begin");
    if (bench_.clocked) line("    clk_i = 1'b0;");
    line("    #1;");
    line(
        fmt::format("    for (clock = 0; clock < {}; clock = clock + 1) begin", traffic_.clocks()));
    seeks();
    line("      " + names(inputs_) + " = drive[clock];");
    line("      #1;");
    line("      if (clock > 0) compare;");
    line("      edges(1);");
    deposits();
    line("    end");
    line(fmt::format("    $display(\"PASS: {}, {} clocks\");", traffic_.unit, traffic_.clocks()));
    line("    $finish;");
    line("  end");
  }

  const VerilogBench& bench_;
  const PortTraffic& traffic_;
  std::vector<std::size_t> inputs_, outputs_;
  std::string text_;
};

}  // namespace

std::string verilog_bench_text(const VerilogBench& bench) { return Writer(bench).text(); }

}  // namespace racebeam
