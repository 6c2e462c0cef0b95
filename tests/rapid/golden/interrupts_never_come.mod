MODULE interrupts_never_come
    VAR intnum i;
    PROC main()
        CONNECT i WITH alarm;
        Stop;
        WaitTime 1;
    ENDPROC
    TRAP alarm
        WaitTime 99;
    ENDTRAP
ENDMODULE
