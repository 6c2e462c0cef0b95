MODULE frames_taken_as_identity
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PERS wobjdata wTurn:=[FALSE,FALSE,"STN1",[[9,9,9],[1,0,0,0]],[[0,0,50],[1,0,0,0]]];
    PROC main()
        MoveL p0,v500,fine,tGrip\WObj:=wTurn;
        MoveL p0,v500,fine,tGrip\WObj:=wTurn;
    ENDPROC
ENDMODULE
