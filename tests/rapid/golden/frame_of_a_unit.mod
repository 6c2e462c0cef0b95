MODULE frame_of_a_unit
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PERS wobjdata wTurn:=[FALSE,FALSE,"STN1",[[9,9,9],[1,0,0,0]],[[0,0,50],[1,0,0,0]]];
    PROC main()
        MoveL p0,v500,fine,tool0\WObj:=wTurn;
    ENDPROC
ENDMODULE
