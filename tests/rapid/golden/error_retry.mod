MODULE error_retry
    VAR num part;
    PROC main()
        FOR i FROM 1 TO 3 DO
            WaitTime 6/part;
            part:=0;
        ENDFOR
    ERROR
        IF ERRNO=ERR_DIVZERO THEN
            part:=2;
            RETRY;
        ENDIF
    ENDPROC
ENDMODULE
