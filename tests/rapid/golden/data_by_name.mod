MODULE data_by_name
    VAR num t;
    CONST num time_1:=1;
    VAR num time_2:=2;
    PERS num time_3:=3;
    PROC main()
        FOR i FROM 1 TO 3 DO
            GetDataVal "time_"+NumToStr(i,0),t;
            WaitTime t;
        ENDFOR
        SetDataVal "TIME_2",20;
        WaitTime time_2;
        SetDataVal "time_3",t+1;
        WaitTime time_3;
    ENDPROC
ENDMODULE
