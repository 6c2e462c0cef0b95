MODULE displacement_from_point
    CONST robtarget pOld:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget pNew:=[[500,100,600],[0,0.70710678,0.70710678,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget pNext:=[[600,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        PDispOn\ExeP:=pNew,pOld,tool0;
        MoveL pNext,v500,fine,tool0;
        PDispOn\Rot\ExeP:=pNew,pOld,tool0;
        MoveL pOld,v500,fine,tool0;
        MoveL pNext,v500,fine,tool0;
    ENDPROC
ENDMODULE
