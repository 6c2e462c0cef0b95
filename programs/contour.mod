MODULE Contour
    ! An IRB 140 on a bench, no rail: drives a cutter round the outline of a cam, 60 points 7 mm apart.
    ! The points are computed: the outline's radius swells and shrinks three times in one turn.

    CONST jointtarget j_home:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PERS tooldata tCutter:=[TRUE,[[0,0,150],[1,0,0,0]],[1.5,[0,0,70],[1,0,0,0],0,0,0]];
    PERS wobjdata wCam:=[FALSE,TRUE,"",[[440,130,150],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];

    CONST robtarget p_middle:=[[0,0,0],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST num steps:=60;
    CONST num mean:=65; ! mm
    CONST num swell:=6; ! mm

    PROC main()
        MoveJ Offs(p_middle,mean+swell+20,0,40), v1000, z10, tCutter\WObj:=wCam;
        MoveL Offs(p_middle,mean+swell+20,0,0), v200, z5, tCutter\WObj:=wCam;
        Outline;
        MoveL Offs(p_middle,mean+swell,0,40), v500, z10, tCutter\WObj:=wCam;
        MoveAbsJ j_home\NoEOffs, v1000, fine, tCutter;
    ENDPROC

    PROC Outline()
        VAR num angle;
        VAR num radius;

        MoveL Offs(p_middle,mean+swell,0,0), v100, fine, tCutter\WObj:=wCam;
        FOR i FROM 1 TO steps-1 DO
            angle:=360*i/steps;
            radius:=mean+swell*Cos(3*angle);
            MoveL Offs(p_middle,radius*Cos(angle),radius*Sin(angle),0), v100, z1, tCutter\WObj:=wCam;
        ENDFOR
        MoveL Offs(p_middle,mean+swell,0,0), v100, fine, tCutter\WObj:=wCam;
    ENDPROC
ENDMODULE
