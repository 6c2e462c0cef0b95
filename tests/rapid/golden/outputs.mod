MODULE outputs
    PROC main()
        SetDO do1,high;
        SetDO\SDelay:=0.2,do2,5;
        SetDO\Sync,do1,low;
        Set do3;
        Reset do3;
        InvertDO do4;
        PulseDO\High\PLength:=0.3,do4;
        PulseDO do4;
        SetGO go1,9;
        SetAO ao1,-2.5;
        WaitTime 1000*DOutput(do5)+100*do4+10*GOutput(go1)+AOutput(ao1);
        WaitTime DOutput(do6);
    ENDPROC
ENDMODULE
