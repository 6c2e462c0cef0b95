MODULE calc_rob_t
    CONST jointtarget j1:=[[0,0,0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j2:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j3:=[[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j4:=[[90,0,0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j5:=[[-90,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j6:=[[30,20,10,45,30,60],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j7:=[[-45,-30,20,-100,60,200],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j8:=[[120,40,-60,190,-45,-270],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j9:=[[23.9625,6.7721,-7.1508,90.852,-23.9653,-90.9324],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j10:=[[23.9625,92.3536,-172.849,-24.2578,81.3214,3.8899],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j11:=[[-156.038,-83.6501,-38.9353,152.189,60.5187,14.5523],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j12:=[[-156.038,-31.1061,-141.065,107.04,25.1372,71.296],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveJ CalcRobT(j1,tool0),v500,fine,tool0;
        MoveJ CalcRobT(j2,tool0),v500,fine,tool0;
        MoveJ CalcRobT(j3,tool0),v500,fine,tool0;
        MoveJ CalcRobT(j4,tool0),v500,fine,tool0;
        MoveJ CalcRobT(j5,tool0),v500,fine,tool0;
        MoveJ CalcRobT(j6,tool0),v500,fine,tool0;
        MoveJ CalcRobT(j7,tool0),v500,fine,tool0;
        MoveJ CalcRobT(j8,tool0),v500,fine,tool0;
        MoveJ CalcRobT(j9,tool0),v500,fine,tool0;
        MoveJ CalcRobT(j10,tool0),v500,fine,tool0;
        MoveJ CalcRobT(j11,tool0),v500,fine,tool0;
        MoveJ CalcRobT(j12,tool0),v500,fine,tool0;
    ENDPROC
ENDMODULE
