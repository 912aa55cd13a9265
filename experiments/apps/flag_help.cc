// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/flag_help.h"

#include <gflags/gflags.h>

#include <ostream>
#include <string_view>

#include "experiments/apps/command_line.h"

namespace gmapping_spa::apps {
namespace {

std::string Escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&') {
      escaped += "&amp;";
    } else if (c == '<') {
      escaped += "&lt;";
    } else if (c == '>') {
      escaped += "&gt;";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string Element(const std::string& name, const std::string& text) {
  return "<" + name + ">" + Escaped(text) + "</" + name + ">";
}

}  // namespace

void PrintHelp(const std::string& program, const FlagGroups& groups, std::ostream& out) {
  out << program << ": " << gflags::ProgramUsage() << '\n';
  for (const FlagGroup& group : groups) {
    out << '\n' << group.title << ":\n";
    for (const std::string& name : group.flags) {
      gflags::CommandLineFlagInfo flag = gflags::GetCommandLineFlagInfoOrDie(name.c_str());
      flag.default_value = ShortValue(flag.type, flag.default_value);
      flag.current_value = ShortValue(flag.type, flag.current_value);
      out << gflags::DescribeOneFlag(flag);
    }
  }
  out << "\nFlags can also be read from a file with one --flag=value a line: --flagfile=FILE;\n"
         "the command line wins over files, a later file over an earlier one.\n"
         "--helpfull prints the flags of the libraries, too.\n";
}

void PrintHelpXml(const std::string& program, const FlagGroups& groups, std::ostream& out) {
  out << "<?xml version=\"1.0\"?>\n<AllFlags>\n"
      << Element("program", program) << '\n'
      << Element("usage", gflags::ProgramUsage()) << '\n';
  for (const FlagGroup& group : groups) {
    out << "<group>" << Element("name", group.name) << Element("title", group.title) << '\n';
    for (const std::string& name : group.flags) {
      const auto flag = gflags::GetCommandLineFlagInfoOrDie(name.c_str());
      out << "<flag>" << Element("name", flag.name) << Element("meaning", flag.description)
          << Element("default", flag.default_value) << Element("current", flag.current_value)
          << Element("type", flag.type) << "</flag>\n";
    }
    out << "</group>\n";
  }
  out << "</AllFlags>\n";
}

}  // namespace gmapping_spa::apps
