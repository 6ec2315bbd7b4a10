#include "io/states/plan_file.h"

#include "io/files/atomic_file.h"
#include "io/files/checksum.h"
#include "io/states/block_file.h"
#include "io/states/info_bytes.h"
#include "io/states/value_bytes.h"
#include "io/text/read_error.h"

#include <stdexcept>

namespace abbe {

void write_plan_file(const std::filesystem::path& file, const PlanFile& plan) {
  replace_file(file, [&](const std::filesystem::path& temporary) {
    BlockWriter writer(temporary);
    ValueWriter out;
    put_info(out, plan.info);
    writer.write("INFO", out.bytes());
    out.clear();
    for (const int edge : {plan.window.x0, plan.window.y0, plan.window.x1, plan.window.y1})
      out.put(std::int32_t{edge});
    out.put(plan.shares);
    writer.write("PLAN", out.bytes());
    writer.end();
  });
}

PlanFile read_plan_file(const std::filesystem::path& file) {
  BlockReader blocks(file);
  PlanFile plan;
  try {
    ValueReader info(blocks.read("INFO"));
    plan.info = get_info(info);
    info.end();
    const std::string& content = blocks.read("PLAN");
    plan.checksum = Checksum().add(content).value();
    ValueReader in(content);
    for (int* edge : {&plan.window.x0, &plan.window.y0, &plan.window.x1, &plan.window.y1})
      *edge = in.get<std::int32_t>();
    plan.shares = in.list<float>();
    in.end();
  } catch (const ReadError&) {
    throw;
  } catch (const std::runtime_error& error) {
    blocks.refuse(error.what());
  }
  blocks.end();
  return plan;
}

} // namespace abbe
