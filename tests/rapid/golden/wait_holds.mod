MODULE wait_holds
    PROC main()
        WaitDI diUnknown,1;
        WaitTime 10+diUnknown;
        WaitTime 20+diNo;
        WaitDI diNo,1;
        WaitTime 30+diNo;
        WaitDO doSet,1;
        WaitTime 40+doSet;
        SetDO doSet,0;
        WaitTime 50+doSet;
    ENDPROC
ENDMODULE
