MODULE mirrored_target
    PERS wobjdata wSide:=[FALSE,TRUE,"",[[0,0,0],[1,0,0,0]],[[0,0,0],[0.70710678,0.70710678,0,0]]];
    CONST robtarget p0:=[[500,100,600],[0.5,0.5,0.5,0.5],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveL MirPos(p0,wSide),v500,fine,tool0;
        MoveL MirPos(p0,wSide\MirY),v500,fine,tool0;
    ENDPROC
ENDMODULE
