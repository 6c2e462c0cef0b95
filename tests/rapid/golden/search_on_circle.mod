MODULE search_on_circle
    CONST robtarget pA:=[[600,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget pVia:=[[500,100,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget pB:=[[400,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    VAR robtarget pFound;
    PROC main()
        MoveL pA,v500,fine,tool0;
        SearchC\PStop,diTouch,pFound,pVia,pB,v50,tool0;
        MoveL pFound,v50,fine,tool0;
    ENDPROC
ENDMODULE
