MODULE process_data_unread
    PERS welddata weld1:=[10,0,[5,0,"a"],[0,0]];
    PERS gadget unknown:=[1,2,3];
    VAR clock watch;
    PROC main()
        weld1.org_weld_speed:=12;
        WaitTime 1;
    ENDPROC
ENDMODULE
