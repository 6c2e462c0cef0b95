MODULE wait_until
    VAR bool done;
    VAR bool busy:=TRUE;
    VAR num part:=3;
    VAR num stage;
    PROC main()
        WaitUntil di1=1 AND TestDI(di2) AND done AND gi1=2*part+1 AND NOT busy;
        WaitTime 100*di1+10*DInput(di2)+gi1;
        IF done AND NOT busy WaitTime 1;
        WaitUntil \InPos,di5=1 OR di6>3\PollRate:=0.1;
        WaitUntil stage=4;
        WaitTime stage;
    ENDPROC
ENDMODULE
