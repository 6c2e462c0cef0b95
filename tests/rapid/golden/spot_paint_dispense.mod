MODULE spot_paint_dispense
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        SpotL p0,v500,gun1,spot10,tool0;
        SpotJ p0,vmax,gun1,spot10\InPos,tool0;
        PaintL p0,v500,z20,tool0;
        DispL\On,p0,v200,bead1,z30,tool0;
        CapL p0,v50,cdata1,weave1,z1,tool0;
    ENDPROC
ENDMODULE
