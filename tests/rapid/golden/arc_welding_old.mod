MODULE arc_welding_old
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p1:=[[600,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PERS seamdata seam1:=[0,0,0];
    PERS welddata weld1:=[10,12.5,0,0,0,0,0,0,0];
    PERS weavedata weave1:=[0,0,0];
    PROC main()
        ArcL\On,p0,v200,seam1,weld1,weave1,fine,tool0;
        ArcL\Off,p1,v200,seam1,weld1,weave1,fine,tool0;
    ENDPROC
ENDMODULE
