MODULE where_the_robot_is
    PERS wobjdata w:=[FALSE,TRUE,"",[[1000,0,0],[0.70710678,0,0,0.70710678]],[[0,0,50],[1,0,0,0]]];
    PERS tooldata tTip:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[12,9E9,9E9,9E9,9E9,9E9]];
    VAR robtarget r;
    VAR pos s;
    PROC main()
        MoveL p0,v500,fine,tTip\WObj:=w;
        r:=CRobT();
        MoveL r,v500,fine,tTip\WObj:=w;
        r:=CRobT(\Tool:=tool0\WObj:=wobj0);
        MoveL r,v500,fine,tool0;
        s:=CPos(\Tool:=tTip);
        r.trans:=s+[0,0,1];
        MoveL r,v500,fine,tTip;
    ENDPROC
ENDMODULE
