MODULE arc_welding
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p1:=[[600,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p2:=[[700,100,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p3:=[[800,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PERS seamdata seam1:=[0.5,0.5,[0,0,0,0,0,0,0,0,0],0,0,0,0,0,[0,0,0,0,0,0,0,0,0],0,0,[0,0,0,0,0,0,0,0,0],0,0,[0,0,0,0,0,0,0,0,0],0];
    PERS welddata weld1:=[8,8,[5,0,22,120,0,0,0,0,0],[0,0,0,0,0,0,0,0,0]];
    PROC main()
        ArcLStart p0,v200,seam1,weld1,fine,tool0;
        ArcL p1,v200,seam1,weld1\Weave:=weave1,z1,tool0;
        ArcCEnd p2,p3,v200,seam1,weld1,fine,tool0\WObj:=wobj0;
    ENDPROC
ENDMODULE
