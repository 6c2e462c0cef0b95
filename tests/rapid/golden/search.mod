MODULE search
    PERS wobjdata w:=[FALSE,TRUE,"",[[1000,0,0],[0.70710678,0,0,0.70710678]],[[0,0,50],[1,0,0,0]]];
    CONST robtarget pA:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget pB:=[[500,0,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    VAR robtarget pFound;
    PROC main()
        MoveL pA,v500,fine,tool0\WObj:=w;
        SearchL\Stop,diTouch,pFound,pB,v50,tool0\WObj:=w;
        MoveL Offs(pFound,0,0,10),v50,fine,tool0\WObj:=w;
        SearchL diTouch,pFound,pB,v50,tool0\WObj:=w;
        MoveL pFound,v50,fine,tool0;
    ENDPROC
ENDMODULE
