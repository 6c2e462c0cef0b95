MODULE displacement_kept
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        PDispSet [[0,0,60],[1,0,0,0]];
        EOffsSet [250,0,0,0,0,0];
        clean;
        MoveL p0,v200,fine,tool0;
    ENDPROC
    PROC clean()
        VAR progdisp kept;
        kept:=C_PROGDISP;
        PDispOff;
        EOffsOff;
        MoveL p0,v200,fine,tool0;
        PDispSet kept.pdisp;
        EOffsSet kept.eoffs;
    ENDPROC
ENDMODULE
