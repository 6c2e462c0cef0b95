"""Expressions as machine code: CasADi's functions written as LLVM IR, compiled in memory and kept in a cache."""
