#pragma once

namespace deltaform
{
  /**
   * The program: do what the command line asks for, in this process or, for a sweep, in copies of it. Errors are said
   * on standard error, by one process for all. MPI must not have been started; it is started where
   * the command needs it.
   * @param argv as main() has it
   * @return the exit status
   */
  int run_program(int argc, char *argv[]);
} // namespace deltaform
