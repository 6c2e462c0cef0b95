MODULE name_misspelt
    CONST robtarget pHome:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveL pHoem,v100,fine,tool0;
    ENDPROC
ENDMODULE
