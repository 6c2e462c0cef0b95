MODULE data_unknown_by_name
    VAR num t;
    PROC main()
        GetDataVal "tme",t;
    ENDPROC
ENDMODULE
