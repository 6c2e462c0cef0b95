MODULE trigger_not_set_up
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    VAR triggdata tOn;
    PROC main()
        TriggL p0,v200,tOn,z10,tool0;
    ENDPROC
ENDMODULE
