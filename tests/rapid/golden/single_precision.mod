MODULE single_precision
    VAR num n:=16777216;
    VAR dnum d:=16777216;
    VAR num tenth:=0.1;
    PROC main()
        IF n+1=n WaitTime 1;
        IF d+1=16777217 WaitTime 2;
        IF tenth+0.2=0.3 WaitTime 3;
        WaitTime tenth;
    ENDPROC
ENDMODULE
