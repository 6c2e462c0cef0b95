MODULE both_held
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PERS wobjdata wHeld:=[TRUE,TRUE,"",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
    PROC main()
        MoveL p0,v500,fine,tool0\WObj:=wHeld;
    ENDPROC
ENDMODULE
