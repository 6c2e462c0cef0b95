MODULE modal_settings
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PERS loaddata lPart:=[2.5,[0,0,40],[1,0,0,0],0.01,0.01,0.02];
    PROC main()
        ConfL\Off;
        ConfJ\Off;
        SingArea\Wrist;
        AccSet 60,80;
        PathAccLim TRUE\AccMax:=4,FALSE;
        WorldAccLim\On:=3.5;
        GripLoad lPart;
        MoveL p0,v500,fine,tool0;
        ConfL\On;
        ConfJ\On;
        SingArea\Off;
        AccSet 100,100;
        PathAccLim FALSE,FALSE;
        WorldAccLim\Off;
        GripLoad load0;
        MoveL p0,v500,fine,tool0;
        AccSet 5,100;
        MoveL p0,v500,fine,tool0;
    ENDPROC
ENDMODULE
