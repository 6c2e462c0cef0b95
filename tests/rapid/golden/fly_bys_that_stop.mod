MODULE FlyBysThatStop
    PERS tooldata tTip:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
    CONST robtarget p:=[[450,0,600],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveJ p, v500, z10, tool0;
        WaitTime 0.1;
        MoveL Offs(p,100,0,0), v500, z10, tool0;
        WaitTime 0;
        SetDO doGlue, 1;
        MoveL Offs(p,100,100,0), v500, z10, tool0;
        WaitDI diPart, 1;
        MoveL Offs(p,0,100,0), v500, z10, tool0;
        MoveL Offs(p,0,100,0), v500, z20, tTip;
        MoveL RelTool(Offs(p,0,100,0),0,0,0\Rz:=20), v500, z10, tTip;
        MoveL Offs(p,0,200,0), v500, z10\Z:=0, tTip;
        MoveL Offs(p,0,0,0), v500, z5, tTip;
        MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[50,9E9,9E9,9E9,9E9,9E9]], vlin10, z5;
        MoveL Offs(p,50,0,0), v500, z50, tTip;
        SetDO doGlue, 0;
    ENDPROC
ENDMODULE
