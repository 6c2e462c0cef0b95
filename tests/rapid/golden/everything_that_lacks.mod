MODULE everything_that_lacks
    VAR num key;
    VAR socketdev s;
    VAR string text;
    VAR bool ok;
    VAR iodev channel;
    VAR pos spot;
    PROC main()
        IF di1=1 WaitTime 1;
        IF di1=0 AND TestDI(di2) WaitTime 1;
        TPReadFK key,"Which?",stEmpty,"A","B",stEmpty,stEmpty;
        TPReadNum key,"Asked by the same name";
        SocketReceive s\Str:=text;
        ok:=IsFile("HOME:x");
        ReadAnyBin channel,spot;
    ENDPROC
ENDMODULE
