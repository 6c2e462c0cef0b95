MODULE out_of_reach
    CONST robtarget pFar:=[[5000,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    VAR jointtarget j;
    PROC main()
        j:=CalcJointT(pFar,tool0);
    ENDPROC
ENDMODULE
