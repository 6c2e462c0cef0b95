MODULE loops_restore
    VAR num i:=7;
    PROC main()
        FOR i FROM 1 TO 2 DO
            leave;
        ENDFOR
        WaitTime i;
    ENDPROC
    PROC leave()
        VAR num k:=5;
        FOR k FROM 1 TO 3 DO
            IF k=2 RAISE 14;
        ENDFOR
    ERROR
        WaitTime k;
        WaitTime i;
        RETURN;
    ENDPROC
ENDMODULE
