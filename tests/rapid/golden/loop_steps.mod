MODULE loop_steps
    VAR num n;
    PROC main()
        FOR i FROM 1 TO 0 DO
            WaitTime 1+i;
        ENDFOR
        FOR i FROM 1 TO 3 STEP -1 DO
            WaitTime 99;
        ENDFOR
        FOR i FROM 0 TO 1 STEP 0.1 DO
            Incr n;
        ENDFOR
        WaitTime n;
    ENDPROC
ENDMODULE
