MODULE clocks
    VAR clock cycle;
    PROC main()
        ClkStart cycle;
        WaitTime ClkRead(cycle\HighRes);
        WaitTime ClkRead(cycle);
        WaitTime GetTime(\Hour);
        IF CDate()="2026-01-02" AND StrPart(CTime(),1,2)="17" WaitTime 1;
    ENDPROC
ENDMODULE
