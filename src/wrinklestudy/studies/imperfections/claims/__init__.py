"""What an experimenter may expect of imperfections and whether it holds, a module per question."""
