MODULE stationary_tool
    PERS tooldata tStand:=[FALSE,[[800,0,500],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
    PERS wobjdata wHeld:=[TRUE,TRUE,"",[[0,0,100],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
    CONST robtarget pA:=[[0,0,50],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget pB:=[[0,30,90],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveL pA,v100,fine,tStand\WObj:=wHeld;
        MoveL pB,v100,z50,tStand\WObj:=wHeld;
        MoveL pA,v100,fine,tStand\WObj:=wHeld;
    ENDPROC
ENDMODULE
