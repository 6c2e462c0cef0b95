MODULE wait_time_flag
    VAR bool late;
    PROC main()
        WaitDI di1,1\MaxTime:=4\TimeFlag:=late;
        IF late WaitTime 1;
        WaitDI di2,1\MaxTime:=4\TimeFlag:=late;
        IF NOT late WaitTime 2;
        WaitUntil di3=1 OR di4=1\MaxTime:=6\TimeFlag:=late;
        IF late WaitTime 3;
    ENDPROC
ENDMODULE
