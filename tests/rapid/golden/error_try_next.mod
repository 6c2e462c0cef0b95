MODULE error_try_next
    VAR num a{2}:=[4,5];
    PROC main()
        FOR i FROM 1 TO 3 DO
            WaitTime a{i};
        ENDFOR
        deeper;
        WaitTime 9;
    ERROR (ERR_OUTOFBND)
        WaitTime 1;
        TRYNEXT;
    ERROR (ERR_DIVZERO)
        WaitTime 3;
        TRYNEXT;
    ENDPROC
    PROC deeper()
        WaitTime 1/0;
        WaitTime 99;
    ERROR
        WaitTime 2;
        RAISE;
    ENDPROC
ENDMODULE
