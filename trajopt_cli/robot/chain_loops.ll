; sha256 ca43aceeab6a889fa1c1cd64191594a996658d9bb111c3b85a7c64f53e3f71d3 of chain_loops.py and of this
; made by numba 0.68.1, llvmlite 0.50.0, Python 3.11.7
; loops.poses: array(float64, 2d, C); array(float64, 2d, A); array(float64, 1d, A); array(float64, 2d, A); array(float64, 3d, C); array(float64, 2d, A); array(float64, 3d, C)
; loops.points: array(float64, 2d, C); array(float64, 2d, A); array(float64, 1d, A); array(float64, 2d, A); array(float64, 3d, C); array(float64, 2d, A); array(float64, 3d, C)
; loops.jacobians: array(float64, 2d, C); array(float64, 2d, A); array(float64, 1d, A); array(float64, 2d, A); array(float64, 3d, C); array(float64, 2d, A); array(float64, 3d, C)
; loops.motions: array(float64, 2d, C); array(float64, 2d, A); array(float64, 1d, A); array(float64, 2d, A); array(float64, 3d, C); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 3d, C)
; loops.follow: array(float64, 2d, C); array(float64, 2d, A); array(float64, 1d, A); array(float64, 2d, A); array(float64, 3d, C); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, C); array(float64, 2d, C)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.poses(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.chain.0, ptr readnone captures(none) %arg.chain.1, i64 %arg.chain.2, i64 %arg.chain.3, ptr readonly captures(none) %arg.chain.4, i64 %arg.chain.5.0, i64 %arg.chain.5.1, i64 %arg.chain.6.0, i64 %arg.chain.6.1, ptr readnone captures(none) %arg.X_WO.0, ptr readnone captures(none) %arg.X_WO.1, i64 %arg.X_WO.2, i64 %arg.X_WO.3, ptr readonly captures(none) %arg.X_WO.4, i64 %arg.X_WO.5.0, i64 %arg.X_WO.5.1, i64 %arg.X_WO.6.0, i64 %arg.X_WO.6.1, ptr readnone captures(none) %arg.ride.0, ptr readnone captures(none) %arg.ride.1, i64 %arg.ride.2, i64 %arg.ride.3, ptr readonly captures(none) %arg.ride.4, i64 %arg.ride.5.0, i64 %arg.ride.6.0, ptr readnone captures(none) %arg.X_6T.0, ptr readnone captures(none) %arg.X_6T.1, i64 %arg.X_6T.2, i64 %arg.X_6T.3, ptr readonly captures(none) %arg.X_6T.4, i64 %arg.X_6T.5.0, i64 %arg.X_6T.5.1, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr readnone captures(none) %arg.room.0, ptr readnone captures(none) %arg.room.1, i64 %arg.room.2, i64 %arg.room.3, ptr %arg.room.4, i64 %arg.room.5.0, i64 %arg.room.5.1, i64 %arg.room.5.2, i64 %arg.room.6.0, i64 %arg.room.6.1, i64 %arg.room.6.2, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.6.0, i64 %arg.q.6.1, ptr readnone captures(none) %arg.X.0, ptr readnone captures(none) %arg.X.1, i64 %arg.X.2, i64 %arg.X.3, ptr writeonly captures(none) %arg.X.4, i64 %arg.X.5.0, i64 %arg.X.5.1, i64 %arg.X.5.2, i64 %arg.X.6.0, i64 %arg.X.6.1, i64 %arg.X.6.2) local_unnamed_addr #0 {
B0.endif:
  %.244585.not = icmp slt i64 %arg.q.5.0, 1
  br i1 %.244585.not, label %B416, label %B62.lr.ph

B62.lr.ph:                                        ; preds = %B0.endif
  %factor.op.mul = shl i64 %arg.room.5.1, 4
  %.459.reass = mul i64 %factor.op.mul, %arg.room.5.2
  %0 = getelementptr i8, ptr %arg.room.4, i64 %.459.reass
  %.idx554 = mul i64 %arg.room.5.2, 48
  %.idx555 = mul i64 %arg.X.5.2, 24
  %1 = getelementptr i8, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0
  %.idx556 = shl i64 %arg.room.5.2, 4
  %.1069 = shl i64 %arg.X_6T.6.0, 1
  %2 = getelementptr i8, ptr %arg.X_6T.4, i64 %.1069
  %.idx = shl i64 %arg.X.5.2, 4
  %scevgep = getelementptr i8, ptr %arg.X.4, i64 24
  %3 = shl i64 %arg.X.5.1, 3
  %4 = mul i64 %3, %arg.X.5.2
  %.idx.i = mul i64 %arg.room.5.2, 40
  %.162.i = mul i64 %arg.room.5.2, %arg.room.5.1
  %.342.idx.i = shl i64 %.162.i, 4
  %.342.i = getelementptr i8, ptr %arg.room.4, i64 %.342.idx.i
  %5 = getelementptr i8, ptr %.342.i, i64 %.idx.i
  %.3025.i = mul i64 %arg.X_6T.6.1, 3
  %.3028.i = getelementptr i8, ptr %arg.X_6T.4, i64 %.3025.i
  %.3138.i = getelementptr i8, ptr %1, i64 %.3025.i
  %.3248.i = getelementptr i8, ptr %2, i64 %.3025.i
  %6 = getelementptr i8, ptr %.342.i, i64 %.idx554
  %.441.i = add nsw i64 %arg.q.5.1, -6
  %.616.i = mul i64 %arg.X_WO.6.1, 3
  %invariant.gep1129.i = getelementptr i8, ptr %arg.X_WO.4, i64 %.616.i
  %.678.not.i = icmp eq i64 %.441.i, 0
  %invariant.gep.2.i = getelementptr i8, ptr %arg.room.4, i64 16
  %gep.1.2.i = getelementptr double, ptr %invariant.gep.2.i, i64 %arg.room.5.2
  %7 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  %8 = getelementptr i8, ptr %arg.room.4, i64 %.idx556
  %.1904.1.i = getelementptr i8, ptr %arg.room.4, i64 8
  %.2015.1.i = getelementptr i8, ptr %7, i64 8
  %.2126.1.i = getelementptr i8, ptr %8, i64 8
  %.2015.2.i = getelementptr i8, ptr %7, i64 16
  %.2126.2.i = getelementptr i8, ptr %8, i64 16
  %.1281.peel.i = getelementptr i8, ptr %arg.chain.4, i64 8
  %.1299.peel.i = icmp slt i64 %arg.q.5.1, 6
  %.1300.peel.i = select i1 %.1299.peel.i, i64 %arg.q.5.1, i64 0
  %.1301.peel.i = add i64 %.1300.peel.i, %.441.i
  %.1312.peel.i = mul i64 %.1301.peel.i, %arg.q.6.1
  %.1371.peel.i = getelementptr i8, ptr %arg.chain.4, i64 16
  %.1427.peel.i = getelementptr i8, ptr %arg.chain.4, i64 48
  %.1959.peel.i = getelementptr i8, ptr %arg.chain.4, i64 24
  %.2070.peel.i = getelementptr i8, ptr %arg.chain.4, i64 32
  %.2181.peel.i = getelementptr i8, ptr %arg.chain.4, i64 40
  %sunkaddr54.i = shl i64 %.162.i, 3
  %sunkaddr55.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr54.i
  %sunkaddr24.i = getelementptr i8, ptr %.342.i, i64 8
  %sunkaddr60.i = getelementptr i8, ptr %sunkaddr55.i, i64 8
  %sunkaddr26.i = getelementptr i8, ptr %.342.i, i64 16
  %sunkaddr65.i = getelementptr i8, ptr %sunkaddr55.i, i64 16
  %9 = add i64 %.342.idx.i, 16
  %10 = shl i64 %arg.room.5.2, 3
  %11 = or disjoint i64 %factor.op.mul, 8
  %12 = mul i64 %11, %arg.room.5.2
  %13 = add i64 %12, 16
  %14 = shl i64 %arg.room.5.1, 3
  %15 = add i64 %14, 8
  %16 = mul i64 %15, %arg.room.5.2
  %17 = add i64 %16, 16
  %18 = shl i64 %arg.chain.5.1, 3
  %19 = getelementptr i8, ptr %arg.chain.4, i64 %18
  %scevgep26.i = getelementptr i8, ptr %19, i64 48
  %20 = add i64 %arg.q.5.1, -5
  %sunkaddr28.i = getelementptr i8, ptr %arg.room.4, i64 %10
  %sunkaddr33.i = getelementptr i8, ptr %sunkaddr28.i, i64 8
  %sunkaddr39.i = getelementptr i8, ptr %sunkaddr28.i, i64 16
  %.2921.1.i = getelementptr i8, ptr %5, i64 8
  %.3305.1.i = getelementptr i8, ptr %6, i64 8
  %.2921.2.i = getelementptr i8, ptr %5, i64 16
  %.3305.2.i = getelementptr i8, ptr %6, i64 16
  %sunkaddr35 = getelementptr i8, ptr %arg.X_6T.4, i64 %arg.X_6T.6.1
  %sunkaddr36 = getelementptr i8, ptr %1, i64 %arg.X_6T.6.1
  %sunkaddr37 = getelementptr i8, ptr %2, i64 %arg.X_6T.6.1
  %sunkaddr38 = shl i64 %arg.X_6T.6.1, 1
  %sunkaddr39 = getelementptr i8, ptr %arg.X_6T.4, i64 %sunkaddr38
  %sunkaddr41 = getelementptr i8, ptr %1, i64 %sunkaddr38
  %sunkaddr43 = getelementptr i8, ptr %2, i64 %sunkaddr38
  %sunkaddr44 = getelementptr i8, ptr %0, i64 %.idx554
  %sunkaddr51 = shl i64 %arg.X.5.2, 3
  %sunkaddr61 = getelementptr i8, ptr %sunkaddr44, i64 8
  %sunkaddr71 = getelementptr i8, ptr %sunkaddr44, i64 16
  %.1020.1.i = getelementptr i8, ptr %arg.X_WO.4, i64 %arg.X_WO.6.1
  %.1017.2.i = shl i64 %arg.X_WO.6.1, 1
  %.1020.2.i = getelementptr i8, ptr %arg.X_WO.4, i64 %.1017.2.i
  %.1072.2.i = shl i64 %arg.room.5.2, 1
  %gep.2.i = getelementptr double, ptr %arg.room.4, i64 %.1072.2.i
  %gep1130.1.i = getelementptr i8, ptr %invariant.gep1129.i, i64 %arg.X_WO.6.0
  %.764.1.i = getelementptr i8, ptr %arg.ride.4, i64 %arg.ride.6.0
  %21 = getelementptr i8, ptr %arg.X_WO.4, i64 %arg.X_WO.6.0
  %.1020.1.1.i = getelementptr i8, ptr %21, i64 %arg.X_WO.6.1
  %gep.1.1.i = getelementptr double, ptr %.1904.1.i, i64 %arg.room.5.2
  %.1020.2.1.i = getelementptr i8, ptr %21, i64 %.1017.2.i
  %gep.2.1.i = getelementptr double, ptr %.1904.1.i, i64 %.1072.2.i
  %.615.2.i = shl i64 %arg.X_WO.6.0, 1
  %gep1130.2.i = getelementptr i8, ptr %invariant.gep1129.i, i64 %.615.2.i
  %.762.2.i = shl i64 %arg.ride.6.0, 1
  %.764.2.i = getelementptr i8, ptr %arg.ride.4, i64 %.762.2.i
  %22 = getelementptr i8, ptr %arg.X_WO.4, i64 %.615.2.i
  %.1020.1.2.i = getelementptr i8, ptr %22, i64 %arg.X_WO.6.1
  %.1020.2.2.i = getelementptr i8, ptr %22, i64 %.1017.2.i
  %gep.2.2.i = getelementptr double, ptr %invariant.gep.2.i, i64 %.1072.2.i
  br label %B62

B62:                                              ; preds = %part.0, %B62.lr.ph
  %lsr.iv32 = phi i64 [ %arg.q.5.0, %B62.lr.ph ], [ %lsr.iv.next, %part.0 ]
  %lsr.iv30 = phi ptr [ %arg.q.4, %B62.lr.ph ], [ %scevgep31, %part.0 ]
  %lsr.iv = phi ptr [ %scevgep, %B62.lr.ph ], [ %scevgep8, %part.0 ]
  %.621.us.i = load double, ptr %invariant.gep1129.i, align 8, !noalias !0
  store double %.621.us.i, ptr %.342.i, align 8, !noalias !0
  br i1 %.678.not.i, label %B120.us.preheader.i, label %B120.preheader.i

B120.preheader.i:                                 ; preds = %B62
  %.766.i = load double, ptr %arg.ride.4, align 8, !noalias !0
  %.797.i = load double, ptr %lsr.iv30, align 8, !noalias !0
  %.798.i = fmul double %.766.i, %.797.i
  %.799.i = fadd double %.621.us.i, %.798.i
  store double %.799.i, ptr %.342.i, align 8, !noalias !0
  %.1022.i = load double, ptr %arg.X_WO.4, align 8, !noalias !0
  store double %.1022.i, ptr %arg.room.4, align 8, !noalias !0
  %.1022.1.i = load double, ptr %.1020.1.i, align 8, !noalias !0
  store double %.1022.1.i, ptr %7, align 8, !noalias !0
  %.1022.2.i = load double, ptr %.1020.2.i, align 8, !noalias !0
  store double %.1022.2.i, ptr %gep.2.i, align 8, !noalias !0
  %.621.1.i = load double, ptr %gep1130.1.i, align 8, !noalias !0
  store double %.621.1.i, ptr %sunkaddr24.i, align 8, !noalias !0
  %.766.1.i = load double, ptr %.764.1.i, align 8, !noalias !0
  %.797.1.i = load double, ptr %lsr.iv30, align 8, !noalias !0
  %.798.1.i = fmul double %.766.1.i, %.797.1.i
  %.799.1.i = fadd double %.621.1.i, %.798.1.i
  store double %.799.1.i, ptr %sunkaddr24.i, align 8, !noalias !0
  %.1022.11190.i = load double, ptr %21, align 8, !noalias !0
  store double %.1022.11190.i, ptr %.1904.1.i, align 8, !noalias !0
  %.1022.1.1.i = load double, ptr %.1020.1.1.i, align 8, !noalias !0
  store double %.1022.1.1.i, ptr %gep.1.1.i, align 8, !noalias !0
  %.1022.2.1.i = load double, ptr %.1020.2.1.i, align 8, !noalias !0
  store double %.1022.2.1.i, ptr %gep.2.1.i, align 8, !noalias !0
  %.621.2.i = load double, ptr %gep1130.2.i, align 8, !noalias !0
  store double %.621.2.i, ptr %sunkaddr26.i, align 8, !noalias !0
  %.766.2.i = load double, ptr %.764.2.i, align 8, !noalias !0
  %.797.2.i = load double, ptr %lsr.iv30, align 8, !noalias !0
  %.798.2.i = fmul double %.766.2.i, %.797.2.i
  %.799.2.i = fadd double %.621.2.i, %.798.2.i
  br label %B616.endif.2.peel.next.i

B120.us.preheader.i:                              ; preds = %B62
  %.1022.us.i = load double, ptr %arg.X_WO.4, align 8, !noalias !0
  store double %.1022.us.i, ptr %arg.room.4, align 8, !noalias !0
  %.1022.us.1.i = load double, ptr %.1020.1.i, align 8, !noalias !0
  store double %.1022.us.1.i, ptr %7, align 8, !noalias !0
  %.1022.us.2.i = load double, ptr %.1020.2.i, align 8, !noalias !0
  store double %.1022.us.2.i, ptr %gep.2.i, align 8, !noalias !0
  %.621.us.1.i = load double, ptr %gep1130.1.i, align 8, !noalias !0
  store double %.621.us.1.i, ptr %sunkaddr24.i, align 8, !noalias !0
  %.1022.us.11192.i = load double, ptr %21, align 8, !noalias !0
  store double %.1022.us.11192.i, ptr %.1904.1.i, align 8, !noalias !0
  %.1022.us.1.1.i = load double, ptr %.1020.1.1.i, align 8, !noalias !0
  store double %.1022.us.1.1.i, ptr %gep.1.1.i, align 8, !noalias !0
  %.1022.us.2.1.i = load double, ptr %.1020.2.1.i, align 8, !noalias !0
  store double %.1022.us.2.1.i, ptr %gep.2.1.i, align 8, !noalias !0
  %.621.us.2.i = load double, ptr %gep1130.2.i, align 8, !noalias !0
  br label %B616.endif.2.peel.next.i

B616.endif.2.peel.next.i:                         ; preds = %B120.us.preheader.i, %B120.preheader.i
  %storemerge = phi double [ %.799.2.i, %B120.preheader.i ], [ %.621.us.2.i, %B120.us.preheader.i ]
  store double %storemerge, ptr %sunkaddr26.i, align 8, !noalias !0
  %.1022.21191.i = load double, ptr %22, align 8, !noalias !0
  store double %.1022.21191.i, ptr %invariant.gep.2.i, align 8, !noalias !0
  %.1022.1.2.i = load double, ptr %.1020.1.2.i, align 8, !noalias !0
  store double %.1022.1.2.i, ptr %gep.1.2.i, align 8, !noalias !0
  %.1022.2.2.i = load double, ptr %.1020.2.2.i, align 8, !noalias !0
  store double %.1022.2.2.i, ptr %gep.2.2.i, align 8, !noalias !0
  %.1282.peel.i = load double, ptr %.1281.peel.i, align 8, !noalias !0
  %.1314.peel.i = getelementptr i8, ptr %lsr.iv30, i64 %.1312.peel.i
  %.1316.peel.i = load double, ptr %.1314.peel.i, align 8, !noalias !0
  %.1317.peel.i = fmul double %.1282.peel.i, %.1316.peel.i
  %.1372.peel.i = load double, ptr %.1371.peel.i, align 8, !noalias !0
  %.1373.peel.i = fadd double %.1317.peel.i, %.1372.peel.i
  %.1428.peel.i = load double, ptr %.1427.peel.i, align 8, !noalias !0
  %.1430.peel.i = fmul double %.1428.peel.i, 0.000000e+00
  %.1433.peel.i = fsub double %.1373.peel.i, %.1430.peel.i
  %.1471.peel.i = tail call double @llvm.cos.f64(double %.1433.peel.i)
  %.1472.peel.i = tail call double @llvm.sin.f64(double %.1433.peel.i)
  %.1533.peel.i = load double, ptr %arg.chain.4, align 8, !noalias !0
  %.5.i.peel.i = fptosi double %.1533.peel.i to i64
  %.1562.peel.i = add nsw i64 %.5.i.peel.i, 1
  %.1582.peel.i = srem i64 %.1562.peel.i, 3
  %.1584.peel.i = icmp slt i64 %.1582.peel.i, 0
  %.1593.peel.i = add nsw i64 %.1582.peel.i, 3
  %.1573.1.peel.i = select i1 %.1584.peel.i, i64 %.1593.peel.i, i64 %.1582.peel.i
  %.1604.peel.i = add nsw i64 %.5.i.peel.i, 2
  %.1624.peel.i = srem i64 %.1604.peel.i, 3
  %.1626.peel.i = icmp slt i64 %.1624.peel.i, 0
  %.1635.peel.i = add nsw i64 %.1624.peel.i, 3
  %.1615.1.peel.i = select i1 %.1626.peel.i, i64 %.1635.peel.i, i64 %.1624.peel.i
  %.2265.peel.i = icmp slt i64 %.5.i.peel.i, 0
  %.2266.peel.i = select i1 %.2265.peel.i, i64 %arg.room.5.1, i64 0
  %.2267.peel.i = add i64 %.2266.peel.i, %.5.i.peel.i
  %.2287.peel.i = mul i64 %.2267.peel.i, %arg.room.5.2
  %23 = getelementptr double, ptr %arg.room.4, i64 %.2287.peel.i
  %.1849.peel.i = load double, ptr %.342.i, align 8, !noalias !0
  %.1905.peel.i = load double, ptr %arg.room.4, align 8, !noalias !0
  %.1960.peel.i = load double, ptr %.1959.peel.i, align 8, !noalias !0
  %.1961.peel.i = fmul double %.1905.peel.i, %.1960.peel.i
  %.1962.peel.i = fadd double %.1849.peel.i, %.1961.peel.i
  %.2016.peel.i = load double, ptr %7, align 8, !noalias !0
  %.2071.peel.i = load double, ptr %.2070.peel.i, align 8, !noalias !0
  %.2072.peel.i = fmul double %.2016.peel.i, %.2071.peel.i
  %.2073.peel.i = fadd double %.1962.peel.i, %.2072.peel.i
  %.2127.peel.i = load double, ptr %8, align 8, !noalias !0
  %.2182.peel.i = load double, ptr %.2181.peel.i, align 8, !noalias !0
  %.2183.peel.i = fmul double %.2127.peel.i, %.2182.peel.i
  %.2184.peel.i = fadd double %.2073.peel.i, %.2183.peel.i
  store double %.2184.peel.i, ptr %.342.i, align 8, !noalias !0
  %.2292.peel.i = load double, ptr %23, align 8, !noalias !0
  store double %.2292.peel.i, ptr %sunkaddr55.i, align 8, !noalias !0
  %.1849.1.peel.i = load double, ptr %sunkaddr24.i, align 8, !noalias !0
  %.1905.1.peel.i = load double, ptr %.1904.1.i, align 8, !noalias !0
  %.1960.1.peel.i = load double, ptr %.1959.peel.i, align 8, !noalias !0
  %.1961.1.peel.i = fmul double %.1905.1.peel.i, %.1960.1.peel.i
  %.1962.1.peel.i = fadd double %.1849.1.peel.i, %.1961.1.peel.i
  %.2016.1.peel.i = load double, ptr %.2015.1.i, align 8, !noalias !0
  %.2071.1.peel.i = load double, ptr %.2070.peel.i, align 8, !noalias !0
  %.2072.1.peel.i = fmul double %.2016.1.peel.i, %.2071.1.peel.i
  %.2073.1.peel.i = fadd double %.1962.1.peel.i, %.2072.1.peel.i
  %.2127.1.peel.i = load double, ptr %.2126.1.i, align 8, !noalias !0
  %.2182.1.peel.i = load double, ptr %.2181.peel.i, align 8, !noalias !0
  %.2183.1.peel.i = fmul double %.2127.1.peel.i, %.2182.1.peel.i
  %.2184.1.peel.i = fadd double %.2073.1.peel.i, %.2183.1.peel.i
  store double %.2184.1.peel.i, ptr %sunkaddr24.i, align 8, !noalias !0
  %.2291.1.peel.i = getelementptr i8, ptr %23, i64 8
  %.2292.1.peel.i = load double, ptr %.2291.1.peel.i, align 8, !noalias !0
  store double %.2292.1.peel.i, ptr %sunkaddr60.i, align 8, !noalias !0
  %.1849.2.peel.i = load double, ptr %sunkaddr26.i, align 8, !noalias !0
  %.1905.2.peel.i = load double, ptr %invariant.gep.2.i, align 8, !noalias !0
  %.1960.2.peel.i = load double, ptr %.1959.peel.i, align 8, !noalias !0
  %.1961.2.peel.i = fmul double %.1905.2.peel.i, %.1960.2.peel.i
  %.1962.2.peel.i = fadd double %.1849.2.peel.i, %.1961.2.peel.i
  %.2016.2.peel.i = load double, ptr %.2015.2.i, align 8, !noalias !0
  %.2071.2.peel.i = load double, ptr %.2070.peel.i, align 8, !noalias !0
  %.2072.2.peel.i = fmul double %.2016.2.peel.i, %.2071.2.peel.i
  %.2073.2.peel.i = fadd double %.1962.2.peel.i, %.2072.2.peel.i
  %.2127.2.peel.i = load double, ptr %.2126.2.i, align 8, !noalias !0
  %.2182.2.peel.i = load double, ptr %.2181.peel.i, align 8, !noalias !0
  %.2183.2.peel.i = fmul double %.2127.2.peel.i, %.2182.2.peel.i
  %.2184.2.peel.i = fadd double %.2073.2.peel.i, %.2183.2.peel.i
  store double %.2184.2.peel.i, ptr %sunkaddr26.i, align 8, !noalias !0
  %.2291.2.peel.i = getelementptr i8, ptr %23, i64 16
  %.2292.2.peel.i = load double, ptr %.2291.2.peel.i, align 8, !noalias !0
  store double %.2292.2.peel.i, ptr %sunkaddr65.i, align 8, !noalias !0
  %.2501.peel.i = icmp slt i64 %.1573.1.peel.i, 0
  %.2502.peel.i = select i1 %.2501.peel.i, i64 %arg.room.5.1, i64 0
  %.2503.peel.i = add i64 %.2502.peel.i, %.1573.1.peel.i
  %.2523.peel.i = mul i64 %.2503.peel.i, %arg.room.5.2
  %24 = getelementptr double, ptr %arg.room.4, i64 %.2523.peel.i
  %.2556.peel.i = icmp slt i64 %.1615.1.peel.i, 0
  %.2557.peel.i = select i1 %.2556.peel.i, i64 %arg.room.5.1, i64 0
  %.2558.peel.i = add i64 %.2557.peel.i, %.1615.1.peel.i
  %.2578.peel.i = mul i64 %.2558.peel.i, %arg.room.5.2
  %25 = getelementptr double, ptr %arg.room.4, i64 %.2578.peel.i
  %.2528.peel.i = load double, ptr %24, align 8, !noalias !0
  %.2583.peel.i = load double, ptr %25, align 8, !noalias !0
  %.2587.peel.i = fmul double %.1471.peel.i, %.2528.peel.i
  %.2589.peel.i = fmul double %.1472.peel.i, %.2583.peel.i
  %.2590.peel.i = fadd double %.2587.peel.i, %.2589.peel.i
  %.2592.peel.i = fmul double %.1471.peel.i, %.2583.peel.i
  %.2594.peel.i = fmul double %.1472.peel.i, %.2528.peel.i
  %.2595.peel.i = fsub double %.2592.peel.i, %.2594.peel.i
  store double %.2590.peel.i, ptr %24, align 8, !noalias !0
  store double %.2595.peel.i, ptr %25, align 8, !noalias !0
  %.2527.1.peel.i = getelementptr i8, ptr %24, i64 8
  %.2528.1.peel.i = load double, ptr %.2527.1.peel.i, align 8, !noalias !0
  %.2582.1.peel.i = getelementptr i8, ptr %25, i64 8
  %.2583.1.peel.i = load double, ptr %.2582.1.peel.i, align 8, !noalias !0
  %.2587.1.peel.i = fmul double %.1471.peel.i, %.2528.1.peel.i
  %.2589.1.peel.i = fmul double %.1472.peel.i, %.2583.1.peel.i
  %.2590.1.peel.i = fadd double %.2587.1.peel.i, %.2589.1.peel.i
  %.2592.1.peel.i = fmul double %.1471.peel.i, %.2583.1.peel.i
  %.2594.1.peel.i = fmul double %.1472.peel.i, %.2528.1.peel.i
  %.2595.1.peel.i = fsub double %.2592.1.peel.i, %.2594.1.peel.i
  store double %.2590.1.peel.i, ptr %.2527.1.peel.i, align 8, !noalias !0
  store double %.2595.1.peel.i, ptr %.2582.1.peel.i, align 8, !noalias !0
  %.2527.2.peel.i = getelementptr i8, ptr %24, i64 16
  %.2528.2.peel.i = load double, ptr %.2527.2.peel.i, align 8, !noalias !0
  %.2582.2.peel.i = getelementptr i8, ptr %25, i64 16
  %.2583.2.peel.i = load double, ptr %.2582.2.peel.i, align 8, !noalias !0
  %.2587.2.peel.i = fmul double %.1471.peel.i, %.2528.2.peel.i
  %.2589.2.peel.i = fmul double %.1472.peel.i, %.2583.2.peel.i
  %.2590.2.peel.i = fadd double %.2587.2.peel.i, %.2589.2.peel.i
  %.2592.2.peel.i = fmul double %.1471.peel.i, %.2583.2.peel.i
  %.2594.2.peel.i = fmul double %.1472.peel.i, %.2528.2.peel.i
  %.2595.2.peel.i = fsub double %.2592.2.peel.i, %.2594.2.peel.i
  store double %.2590.2.peel.i, ptr %.2527.2.peel.i, align 8, !noalias !0
  store double %.2595.2.peel.i, ptr %.2582.2.peel.i, align 8, !noalias !0
  br label %B616.endif.2.i

B616.endif.2.i:                                   ; preds = %B616.endif.2.i, %B616.endif.2.peel.next.i
  %lsr.iv37.i = phi i64 [ 5, %B616.endif.2.peel.next.i ], [ %lsr.iv.next38.i, %B616.endif.2.i ]
  %lsr.iv35.i = phi i64 [ %20, %B616.endif.2.peel.next.i ], [ %lsr.iv.next36.i, %B616.endif.2.i ]
  %lsr.iv27.i = phi ptr [ %scevgep26.i, %B616.endif.2.peel.next.i ], [ %scevgep28.i, %B616.endif.2.i ]
  %lsr.iv19.i = phi i64 [ %17, %B616.endif.2.peel.next.i ], [ %lsr.iv.next20.i, %B616.endif.2.i ]
  %lsr.iv12.i = phi i64 [ %13, %B616.endif.2.peel.next.i ], [ %lsr.iv.next13.i, %B616.endif.2.i ]
  %lsr.iv.i = phi i64 [ %9, %B616.endif.2.peel.next.i ], [ %lsr.iv.next.i, %B616.endif.2.i ]
  %before.2.01171.i = phi double [ %.1316.peel.i, %B616.endif.2.peel.next.i ], [ %.1316.i, %B616.endif.2.i ]
  %scevgep32.i = getelementptr i8, ptr %lsr.iv27.i, i64 -48
  %scevgep34.i = getelementptr i8, ptr %lsr.iv27.i, i64 -40
  %.1282.i = load double, ptr %scevgep34.i, align 8, !noalias !0
  %.1299.i = icmp slt i64 %lsr.iv35.i, 0
  %.1300.i = select i1 %.1299.i, i64 %arg.q.5.1, i64 0
  %26 = add i64 %.1300.i, %lsr.iv35.i
  %.1312.i = mul i64 %26, %arg.q.6.1
  %.1314.i = getelementptr i8, ptr %lsr.iv30, i64 %.1312.i
  %.1316.i = load double, ptr %.1314.i, align 8, !noalias !0
  %.1317.i = fmul double %.1282.i, %.1316.i
  %scevgep33.i = getelementptr i8, ptr %lsr.iv27.i, i64 -32
  %.1372.i = load double, ptr %scevgep33.i, align 8, !noalias !0
  %.1373.i = fadd double %.1317.i, %.1372.i
  %.1428.i = load double, ptr %lsr.iv27.i, align 8, !noalias !0
  %.1430.i = fmul double %before.2.01171.i, %.1428.i
  %.1433.i = fsub double %.1373.i, %.1430.i
  %.1471.i = tail call double @llvm.cos.f64(double %.1433.i)
  %.1472.i = tail call double @llvm.sin.f64(double %.1433.i)
  %.1533.i = load double, ptr %scevgep32.i, align 8, !noalias !0
  %.5.i.i = fptosi double %.1533.i to i64
  %.1562.i = add nsw i64 %.5.i.i, 1
  %.1582.i = srem i64 %.1562.i, 3
  %.1584.i = icmp slt i64 %.1582.i, 0
  %.1593.i = add nsw i64 %.1582.i, 3
  %.1573.1.i = select i1 %.1584.i, i64 %.1593.i, i64 %.1582.i
  %.1604.i = add nsw i64 %.5.i.i, 2
  %.1624.i = srem i64 %.1604.i, 3
  %.1626.i = icmp slt i64 %.1624.i, 0
  %.1635.i = add nsw i64 %.1624.i, 3
  %.1615.1.i = select i1 %.1626.i, i64 %.1635.i, i64 %.1624.i
  %scevgep31.i = getelementptr i8, ptr %lsr.iv27.i, i64 -24
  %scevgep30.i = getelementptr i8, ptr %lsr.iv27.i, i64 -16
  %scevgep29.i = getelementptr i8, ptr %lsr.iv27.i, i64 -8
  %.2265.i = icmp slt i64 %.5.i.i, 0
  %.2266.i = select i1 %.2265.i, i64 %arg.room.5.1, i64 0
  %.2267.i = add i64 %.2266.i, %.5.i.i
  %.2287.i = mul i64 %.2267.i, %arg.room.5.2
  %27 = getelementptr double, ptr %arg.room.4, i64 %.2287.i
  %scevgep10.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv.i
  %scevgep11.i = getelementptr i8, ptr %scevgep10.i, i64 -16
  %.1849.i = load double, ptr %scevgep11.i, align 8, !noalias !0
  %.1905.i = load double, ptr %arg.room.4, align 8, !noalias !0
  %.1960.i = load double, ptr %scevgep31.i, align 8, !noalias !0
  %.1961.i = fmul double %.1905.i, %.1960.i
  %.1962.i = fadd double %.1849.i, %.1961.i
  %.2016.i = load double, ptr %sunkaddr28.i, align 8, !noalias !0
  %.2071.i = load double, ptr %scevgep30.i, align 8, !noalias !0
  %.2072.i = fmul double %.2016.i, %.2071.i
  %.2073.i = fadd double %.1962.i, %.2072.i
  %.2127.i = load double, ptr %8, align 8, !noalias !0
  %.2182.i = load double, ptr %scevgep29.i, align 8, !noalias !0
  %.2183.i = fmul double %.2127.i, %.2182.i
  %.2184.i = fadd double %.2073.i, %.2183.i
  %scevgep14.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv12.i
  %scevgep15.i = getelementptr i8, ptr %scevgep14.i, i64 -16
  store double %.2184.i, ptr %scevgep15.i, align 8, !noalias !0
  %.2292.i = load double, ptr %27, align 8, !noalias !0
  %scevgep21.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv19.i
  %scevgep22.i = getelementptr i8, ptr %scevgep21.i, i64 -16
  store double %.2292.i, ptr %scevgep22.i, align 8, !noalias !0
  %scevgep7.i = getelementptr i8, ptr %scevgep10.i, i64 -8
  %.1849.1.i = load double, ptr %scevgep7.i, align 8, !noalias !0
  %.1905.1.i = load double, ptr %.1904.1.i, align 8, !noalias !0
  %.1960.1.i = load double, ptr %scevgep31.i, align 8, !noalias !0
  %.1961.1.i = fmul double %.1905.1.i, %.1960.1.i
  %.1962.1.i = fadd double %.1849.1.i, %.1961.1.i
  %.2016.1.i = load double, ptr %sunkaddr33.i, align 8, !noalias !0
  %.2071.1.i = load double, ptr %scevgep30.i, align 8, !noalias !0
  %.2072.1.i = fmul double %.2016.1.i, %.2071.1.i
  %.2073.1.i = fadd double %.1962.1.i, %.2072.1.i
  %.2127.1.i = load double, ptr %.2126.1.i, align 8, !noalias !0
  %.2182.1.i = load double, ptr %scevgep29.i, align 8, !noalias !0
  %.2183.1.i = fmul double %.2127.1.i, %.2182.1.i
  %.2184.1.i = fadd double %.2073.1.i, %.2183.1.i
  %scevgep5.i = getelementptr i8, ptr %scevgep14.i, i64 -8
  store double %.2184.1.i, ptr %scevgep5.i, align 8, !noalias !0
  %.2291.1.i = getelementptr i8, ptr %27, i64 8
  %.2292.1.i = load double, ptr %.2291.1.i, align 8, !noalias !0
  %scevgep3.i = getelementptr i8, ptr %scevgep21.i, i64 -8
  store double %.2292.1.i, ptr %scevgep3.i, align 8, !noalias !0
  %.1849.2.i = load double, ptr %scevgep10.i, align 8, !noalias !0
  %.1905.2.i = load double, ptr %invariant.gep.2.i, align 8, !noalias !0
  %.1960.2.i = load double, ptr %scevgep31.i, align 8, !noalias !0
  %.1961.2.i = fmul double %.1905.2.i, %.1960.2.i
  %.1962.2.i = fadd double %.1849.2.i, %.1961.2.i
  %.2016.2.i = load double, ptr %sunkaddr39.i, align 8, !noalias !0
  %.2071.2.i = load double, ptr %scevgep30.i, align 8, !noalias !0
  %.2072.2.i = fmul double %.2016.2.i, %.2071.2.i
  %.2073.2.i = fadd double %.1962.2.i, %.2072.2.i
  %.2127.2.i = load double, ptr %.2126.2.i, align 8, !noalias !0
  %.2182.2.i = load double, ptr %scevgep29.i, align 8, !noalias !0
  %.2183.2.i = fmul double %.2127.2.i, %.2182.2.i
  %.2184.2.i = fadd double %.2073.2.i, %.2183.2.i
  store double %.2184.2.i, ptr %scevgep14.i, align 8, !noalias !0
  %.2291.2.i = getelementptr i8, ptr %27, i64 16
  %.2292.2.i = load double, ptr %.2291.2.i, align 8, !noalias !0
  store double %.2292.2.i, ptr %scevgep21.i, align 8, !noalias !0
  %.2501.i = icmp slt i64 %.1573.1.i, 0
  %.2502.i = select i1 %.2501.i, i64 %arg.room.5.1, i64 0
  %.2503.i = add i64 %.2502.i, %.1573.1.i
  %.2523.i = mul i64 %.2503.i, %arg.room.5.2
  %28 = getelementptr double, ptr %arg.room.4, i64 %.2523.i
  %.2556.i = icmp slt i64 %.1615.1.i, 0
  %.2557.i = select i1 %.2556.i, i64 %arg.room.5.1, i64 0
  %.2558.i = add i64 %.2557.i, %.1615.1.i
  %.2578.i = mul i64 %.2558.i, %arg.room.5.2
  %29 = getelementptr double, ptr %arg.room.4, i64 %.2578.i
  %.2528.i = load double, ptr %28, align 8, !noalias !0
  %.2583.i = load double, ptr %29, align 8, !noalias !0
  %.2587.i = fmul double %.1471.i, %.2528.i
  %.2589.i = fmul double %.1472.i, %.2583.i
  %.2590.i = fadd double %.2587.i, %.2589.i
  %.2592.i = fmul double %.1471.i, %.2583.i
  %.2594.i = fmul double %.1472.i, %.2528.i
  %.2595.i = fsub double %.2592.i, %.2594.i
  store double %.2590.i, ptr %28, align 8, !noalias !0
  store double %.2595.i, ptr %29, align 8, !noalias !0
  %.2527.1.i = getelementptr i8, ptr %28, i64 8
  %.2528.1.i = load double, ptr %.2527.1.i, align 8, !noalias !0
  %.2582.1.i = getelementptr i8, ptr %29, i64 8
  %.2583.1.i = load double, ptr %.2582.1.i, align 8, !noalias !0
  %.2587.1.i = fmul double %.1471.i, %.2528.1.i
  %.2589.1.i = fmul double %.1472.i, %.2583.1.i
  %.2590.1.i = fadd double %.2587.1.i, %.2589.1.i
  %.2592.1.i = fmul double %.1471.i, %.2583.1.i
  %.2594.1.i = fmul double %.1472.i, %.2528.1.i
  %.2595.1.i = fsub double %.2592.1.i, %.2594.1.i
  store double %.2590.1.i, ptr %.2527.1.i, align 8, !noalias !0
  store double %.2595.1.i, ptr %.2582.1.i, align 8, !noalias !0
  %.2527.2.i = getelementptr i8, ptr %28, i64 16
  %.2528.2.i = load double, ptr %.2527.2.i, align 8, !noalias !0
  %.2582.2.i = getelementptr i8, ptr %29, i64 16
  %.2583.2.i = load double, ptr %.2582.2.i, align 8, !noalias !0
  %.2587.2.i = fmul double %.1471.i, %.2528.2.i
  %.2589.2.i = fmul double %.1472.i, %.2583.2.i
  %.2590.2.i = fadd double %.2587.2.i, %.2589.2.i
  %.2592.2.i = fmul double %.1471.i, %.2583.2.i
  %.2594.2.i = fmul double %.1472.i, %.2528.2.i
  %.2595.2.i = fsub double %.2592.2.i, %.2594.2.i
  store double %.2590.2.i, ptr %.2527.2.i, align 8, !noalias !0
  store double %.2595.2.i, ptr %.2582.2.i, align 8, !noalias !0
  %lsr.iv.next.i = add i64 %lsr.iv.i, %10
  %lsr.iv.next13.i = add i64 %lsr.iv12.i, %10
  %lsr.iv.next20.i = add i64 %lsr.iv19.i, %10
  %scevgep28.i = getelementptr i8, ptr %lsr.iv27.i, i64 %18
  %lsr.iv.next36.i = add i64 %lsr.iv35.i, 1
  %lsr.iv.next38.i = add nsw i64 %lsr.iv37.i, -1
  %exitcond.not.i = icmp eq i64 %lsr.iv.next38.i, 0
  br i1 %exitcond.not.i, label %part.0, label %B616.endif.2.i, !llvm.loop !3

part.0: ; preds = %B616.endif.2.i
  %.2922.i = load double, ptr %5, align 8, !noalias !0
  %.2976.i = load double, ptr %arg.room.4, align 8, !noalias !0
  %.3030.i = load double, ptr %.3028.i, align 8, !noalias !0
  %.3031.i = fmul double %.2976.i, %.3030.i
  %.3032.i = fadd double %.2922.i, %.3031.i
  %.3086.i = load double, ptr %sunkaddr28.i, align 8, !noalias !0
  %.3140.i = load double, ptr %.3138.i, align 8, !noalias !0
  %.3141.i = fmul double %.3086.i, %.3140.i
  %.3142.i = fadd double %.3032.i, %.3141.i
  %.3196.i = load double, ptr %8, align 8, !noalias !0
  %.3250.i = load double, ptr %.3248.i, align 8, !noalias !0
  %.3251.i = fmul double %.3196.i, %.3250.i
  %.3252.i = fadd double %.3142.i, %.3251.i
  store double %.3252.i, ptr %6, align 8, !noalias !0
  %.2922.1.i = load double, ptr %.2921.1.i, align 8, !noalias !0
  %.2976.1.i = load double, ptr %.1904.1.i, align 8, !noalias !0
  %.3030.1.i = load double, ptr %.3028.i, align 8, !noalias !0
  %.3031.1.i = fmul double %.2976.1.i, %.3030.1.i
  %.3032.1.i = fadd double %.2922.1.i, %.3031.1.i
  %.3086.1.i = load double, ptr %sunkaddr33.i, align 8, !noalias !0
  %.3140.1.i = load double, ptr %.3138.i, align 8, !noalias !0
  %.3141.1.i = fmul double %.3086.1.i, %.3140.1.i
  %.3142.1.i = fadd double %.3032.1.i, %.3141.1.i
  %.3196.1.i = load double, ptr %.2126.1.i, align 8, !noalias !0
  %.3250.1.i = load double, ptr %.3248.i, align 8, !noalias !0
  %.3251.1.i = fmul double %.3196.1.i, %.3250.1.i
  %.3252.1.i = fadd double %.3142.1.i, %.3251.1.i
  store double %.3252.1.i, ptr %.3305.1.i, align 8, !noalias !0
  %.2922.2.i = load double, ptr %.2921.2.i, align 8, !noalias !0
  %.2976.2.i = load double, ptr %invariant.gep.2.i, align 8, !noalias !0
  %.3030.2.i = load double, ptr %.3028.i, align 8, !noalias !0
  %.3031.2.i = fmul double %.2976.2.i, %.3030.2.i
  %.3032.2.i = fadd double %.2922.2.i, %.3031.2.i
  %.3086.2.i = load double, ptr %sunkaddr39.i, align 8, !noalias !0
  %.3140.2.i = load double, ptr %.3138.i, align 8, !noalias !0
  %.3141.2.i = fmul double %.3086.2.i, %.3140.2.i
  %.3142.2.i = fadd double %.3032.2.i, %.3141.2.i
  %.3196.2.i = load double, ptr %.2126.2.i, align 8, !noalias !0
  %.3250.2.i = load double, ptr %.3248.i, align 8, !noalias !0
  %.3251.2.i = fmul double %.3196.2.i, %.3250.2.i
  %.3252.2.i = fadd double %.3142.2.i, %.3251.2.i
  store double %.3252.2.i, ptr %.3305.2.i, align 8, !noalias !0
  %scevgep23 = getelementptr i8, ptr %lsr.iv, i64 -24
  %scevgep13 = getelementptr i8, ptr %lsr.iv, i64 %.idx555
  %scevgep14 = getelementptr i8, ptr %scevgep13, i64 -24
  %.800.us = load double, ptr %arg.room.4, align 8
  %.854.us = load double, ptr %arg.X_6T.4, align 8
  %.855.us = fmul double %.800.us, %.854.us
  %.910.us = load double, ptr %sunkaddr28.i, align 8
  %.964.us = load double, ptr %1, align 8
  %.965.us = fmul double %.910.us, %.964.us
  %.966.us = fadd double %.855.us, %.965.us
  %.1021.us = load double, ptr %8, align 8
  %.1075.us = load double, ptr %2, align 8
  %.1076.us = fmul double %.1021.us, %.1075.us
  %.1077.us = fadd double %.966.us, %.1076.us
  store double %.1077.us, ptr %scevgep23, align 8
  %.800.us.1 = load double, ptr %arg.room.4, align 8
  %.854.us.1 = load double, ptr %sunkaddr35, align 8
  %.855.us.1 = fmul double %.800.us.1, %.854.us.1
  %.910.us.1 = load double, ptr %sunkaddr28.i, align 8
  %.964.us.1 = load double, ptr %sunkaddr36, align 8
  %.965.us.1 = fmul double %.910.us.1, %.964.us.1
  %.966.us.1 = fadd double %.855.us.1, %.965.us.1
  %.1021.us.1 = load double, ptr %8, align 8
  %.1075.us.1 = load double, ptr %sunkaddr37, align 8
  %.1076.us.1 = fmul double %.1021.us.1, %.1075.us.1
  %.1077.us.1 = fadd double %.966.us.1, %.1076.us.1
  %scevgep22 = getelementptr i8, ptr %lsr.iv, i64 -16
  store double %.1077.us.1, ptr %scevgep22, align 8
  %.800.us.2 = load double, ptr %arg.room.4, align 8
  %.854.us.2 = load double, ptr %sunkaddr39, align 8
  %.855.us.2 = fmul double %.800.us.2, %.854.us.2
  %.910.us.2 = load double, ptr %sunkaddr28.i, align 8
  %.964.us.2 = load double, ptr %sunkaddr41, align 8
  %.965.us.2 = fmul double %.910.us.2, %.964.us.2
  %.966.us.2 = fadd double %.855.us.2, %.965.us.2
  %.1021.us.2 = load double, ptr %8, align 8
  %.1075.us.2 = load double, ptr %sunkaddr43, align 8
  %.1076.us.2 = fmul double %.1021.us.2, %.1075.us.2
  %.1077.us.2 = fadd double %.966.us.2, %.1076.us.2
  %scevgep21 = getelementptr i8, ptr %lsr.iv, i64 -8
  store double %.1077.us.2, ptr %scevgep21, align 8
  %.1235.us = load double, ptr %sunkaddr44, align 8
  store double %.1235.us, ptr %lsr.iv, align 8
  store double 0.000000e+00, ptr %scevgep14, align 8
  %.800.us.1604 = load double, ptr %.1904.1.i, align 8
  %.854.us.1605 = load double, ptr %arg.X_6T.4, align 8
  %.855.us.1606 = fmul double %.800.us.1604, %.854.us.1605
  %.910.us.1607 = load double, ptr %sunkaddr33.i, align 8
  %.964.us.1608 = load double, ptr %1, align 8
  %.965.us.1609 = fmul double %.910.us.1607, %.964.us.1608
  %.966.us.1610 = fadd double %.855.us.1606, %.965.us.1609
  %.1021.us.1611 = load double, ptr %.2126.1.i, align 8
  %.1075.us.1612 = load double, ptr %2, align 8
  %.1076.us.1613 = fmul double %.1021.us.1611, %.1075.us.1612
  %.1077.us.1614 = fadd double %.966.us.1610, %.1076.us.1613
  %sunkaddr52 = getelementptr i8, ptr %lsr.iv, i64 %sunkaddr51
  %sunkaddr53 = getelementptr i8, ptr %sunkaddr52, i64 -24
  store double %.1077.us.1614, ptr %sunkaddr53, align 8
  %.800.us.1.1 = load double, ptr %.1904.1.i, align 8
  %.854.us.1.1 = load double, ptr %sunkaddr35, align 8
  %.855.us.1.1 = fmul double %.800.us.1.1, %.854.us.1.1
  %.910.us.1.1 = load double, ptr %sunkaddr33.i, align 8
  %.964.us.1.1 = load double, ptr %sunkaddr36, align 8
  %.965.us.1.1 = fmul double %.910.us.1.1, %.964.us.1.1
  %.966.us.1.1 = fadd double %.855.us.1.1, %.965.us.1.1
  %.1021.us.1.1 = load double, ptr %.2126.1.i, align 8
  %.1075.us.1.1 = load double, ptr %sunkaddr37, align 8
  %.1076.us.1.1 = fmul double %.1021.us.1.1, %.1075.us.1.1
  %.1077.us.1.1 = fadd double %.966.us.1.1, %.1076.us.1.1
  %sunkaddr56 = getelementptr i8, ptr %sunkaddr52, i64 -16
  store double %.1077.us.1.1, ptr %sunkaddr56, align 8
  %.800.us.2.1 = load double, ptr %.1904.1.i, align 8
  %.854.us.2.1 = load double, ptr %sunkaddr39, align 8
  %.855.us.2.1 = fmul double %.800.us.2.1, %.854.us.2.1
  %.910.us.2.1 = load double, ptr %sunkaddr33.i, align 8
  %.964.us.2.1 = load double, ptr %sunkaddr41, align 8
  %.965.us.2.1 = fmul double %.910.us.2.1, %.964.us.2.1
  %.966.us.2.1 = fadd double %.855.us.2.1, %.965.us.2.1
  %.1021.us.2.1 = load double, ptr %.2126.1.i, align 8
  %.1075.us.2.1 = load double, ptr %sunkaddr43, align 8
  %.1076.us.2.1 = fmul double %.1021.us.2.1, %.1075.us.2.1
  %.1077.us.2.1 = fadd double %.966.us.2.1, %.1076.us.2.1
  %sunkaddr59 = getelementptr i8, ptr %sunkaddr52, i64 -8
  store double %.1077.us.2.1, ptr %sunkaddr59, align 8
  %.1235.us.1 = load double, ptr %sunkaddr61, align 8
  store double %.1235.us.1, ptr %sunkaddr52, align 8
  %scevgep12 = getelementptr i8, ptr %scevgep13, i64 -16
  store double 0.000000e+00, ptr %scevgep12, align 8
  %scevgep19 = getelementptr i8, ptr %lsr.iv, i64 %.idx
  %scevgep20 = getelementptr i8, ptr %scevgep19, i64 -24
  %.800.us.2615 = load double, ptr %invariant.gep.2.i, align 8
  %.854.us.2616 = load double, ptr %arg.X_6T.4, align 8
  %.855.us.2617 = fmul double %.800.us.2615, %.854.us.2616
  %.910.us.2618 = load double, ptr %sunkaddr39.i, align 8
  %.964.us.2619 = load double, ptr %1, align 8
  %.965.us.2620 = fmul double %.910.us.2618, %.964.us.2619
  %.966.us.2621 = fadd double %.855.us.2617, %.965.us.2620
  %.1021.us.2622 = load double, ptr %.2126.2.i, align 8
  %.1075.us.2623 = load double, ptr %2, align 8
  %.1076.us.2624 = fmul double %.1021.us.2622, %.1075.us.2623
  %.1077.us.2625 = fadd double %.966.us.2621, %.1076.us.2624
  store double %.1077.us.2625, ptr %scevgep20, align 8
  %.800.us.1.2 = load double, ptr %invariant.gep.2.i, align 8
  %.854.us.1.2 = load double, ptr %sunkaddr35, align 8
  %.855.us.1.2 = fmul double %.800.us.1.2, %.854.us.1.2
  %.910.us.1.2 = load double, ptr %sunkaddr39.i, align 8
  %.964.us.1.2 = load double, ptr %sunkaddr36, align 8
  %.965.us.1.2 = fmul double %.910.us.1.2, %.964.us.1.2
  %.966.us.1.2 = fadd double %.855.us.1.2, %.965.us.1.2
  %.1021.us.1.2 = load double, ptr %.2126.2.i, align 8
  %.1075.us.1.2 = load double, ptr %sunkaddr37, align 8
  %.1076.us.1.2 = fmul double %.1021.us.1.2, %.1075.us.1.2
  %.1077.us.1.2 = fadd double %.966.us.1.2, %.1076.us.1.2
  %scevgep18 = getelementptr i8, ptr %scevgep19, i64 -16
  store double %.1077.us.1.2, ptr %scevgep18, align 8
  %.800.us.2.2 = load double, ptr %invariant.gep.2.i, align 8
  %.854.us.2.2 = load double, ptr %sunkaddr39, align 8
  %.855.us.2.2 = fmul double %.800.us.2.2, %.854.us.2.2
  %.910.us.2.2 = load double, ptr %sunkaddr39.i, align 8
  %.964.us.2.2 = load double, ptr %sunkaddr41, align 8
  %.965.us.2.2 = fmul double %.910.us.2.2, %.964.us.2.2
  %.966.us.2.2 = fadd double %.855.us.2.2, %.965.us.2.2
  %.1021.us.2.2 = load double, ptr %.2126.2.i, align 8
  %.1075.us.2.2 = load double, ptr %sunkaddr43, align 8
  %.1076.us.2.2 = fmul double %.1021.us.2.2, %.1075.us.2.2
  %.1077.us.2.2 = fadd double %.966.us.2.2, %.1076.us.2.2
  %scevgep16 = getelementptr i8, ptr %scevgep19, i64 -8
  store double %.1077.us.2.2, ptr %scevgep16, align 8
  %.1235.us.2 = load double, ptr %sunkaddr71, align 8
  store double %.1235.us.2, ptr %scevgep19, align 8
  %scevgep10 = getelementptr i8, ptr %scevgep13, i64 -8
  store double 0.000000e+00, ptr %scevgep10, align 8
  store double 1.000000e+00, ptr %scevgep13, align 8
  %scevgep8 = getelementptr i8, ptr %lsr.iv, i64 %4
  %scevgep31 = getelementptr i8, ptr %lsr.iv30, i64 %arg.q.6.0
  %lsr.iv.next = add nsw i64 %lsr.iv32, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not, label %B416, label %B62

B416:                                             ; preds = %part.0, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.cos.f64(double) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sin.f64(double) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.points(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.chain.0, ptr readnone captures(none) %arg.chain.1, i64 %arg.chain.2, i64 %arg.chain.3, ptr readonly captures(none) %arg.chain.4, i64 %arg.chain.5.0, i64 %arg.chain.5.1, i64 %arg.chain.6.0, i64 %arg.chain.6.1, ptr readnone captures(none) %arg.X_WO.0, ptr readnone captures(none) %arg.X_WO.1, i64 %arg.X_WO.2, i64 %arg.X_WO.3, ptr readonly captures(none) %arg.X_WO.4, i64 %arg.X_WO.5.0, i64 %arg.X_WO.5.1, i64 %arg.X_WO.6.0, i64 %arg.X_WO.6.1, ptr readnone captures(none) %arg.ride.0, ptr readnone captures(none) %arg.ride.1, i64 %arg.ride.2, i64 %arg.ride.3, ptr readonly captures(none) %arg.ride.4, i64 %arg.ride.5.0, i64 %arg.ride.6.0, ptr readnone captures(none) %arg.X_6T.0, ptr readnone captures(none) %arg.X_6T.1, i64 %arg.X_6T.2, i64 %arg.X_6T.3, ptr readonly captures(none) %arg.X_6T.4, i64 %arg.X_6T.5.0, i64 %arg.X_6T.5.1, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr readnone captures(none) %arg.room.0, ptr readnone captures(none) %arg.room.1, i64 %arg.room.2, i64 %arg.room.3, ptr %arg.room.4, i64 %arg.room.5.0, i64 %arg.room.5.1, i64 %arg.room.5.2, i64 %arg.room.6.0, i64 %arg.room.6.1, i64 %arg.room.6.2, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.6.0, i64 %arg.q.6.1, ptr readnone captures(none) %arg.o.0, ptr readnone captures(none) %arg.o.1, i64 %arg.o.2, i64 %arg.o.3, ptr writeonly captures(none) %arg.o.4, i64 %arg.o.5.0, i64 %arg.o.5.1, i64 %arg.o.5.2, i64 %arg.o.6.0, i64 %arg.o.6.1, i64 %arg.o.6.2) local_unnamed_addr #0 {
B0.endif:
  %.363 = alloca ptr, align 8
  %.244336.not = icmp slt i64 %arg.q.5.0, 1
  br i1 %.244336.not, label %B224, label %B62.lr.ph

B62.lr.ph:                                        ; preds = %B0.endif
  %factor.op.mul324 = shl i64 %arg.room.5.1, 4
  %factor.op.mul.reass = mul i64 %factor.op.mul324, %arg.room.5.2
  %0 = getelementptr i8, ptr %arg.room.4, i64 %factor.op.mul.reass
  call fastcc void @part.1(ptr nonnull %.363, ptr %arg.chain.4, i64 %arg.chain.5.1, ptr %arg.X_WO.4, i64 %arg.X_WO.6.0, i64 %arg.X_WO.6.1, ptr %arg.ride.4, i64 %arg.ride.6.0, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr %arg.room.4, i64 %arg.room.5.1, i64 %arg.room.5.2, ptr %arg.q.4, i64 %arg.q.5.1, i64 %arg.q.6.1)
  %.724.us.peel = load double, ptr %0, align 8
  store double %.724.us.peel, ptr %arg.o.4, align 8
  %1 = getelementptr i8, ptr %0, i64 8
  %.724.us.1.peel = load double, ptr %1, align 8
  %2 = getelementptr i8, ptr %arg.o.4, i64 8
  store double %.724.us.1.peel, ptr %2, align 8
  %3 = getelementptr i8, ptr %0, i64 16
  %.724.us.2.peel = load double, ptr %3, align 8
  %4 = getelementptr i8, ptr %arg.o.4, i64 16
  store double %.724.us.2.peel, ptr %4, align 8
  %5 = getelementptr double, ptr %0, i64 %arg.room.5.2
  %6 = getelementptr double, ptr %arg.o.4, i64 %arg.o.5.2
  %.724.us.1353.peel = load double, ptr %5, align 8
  store double %.724.us.1353.peel, ptr %6, align 8
  %7 = getelementptr i8, ptr %5, i64 8
  %.724.us.1.1.peel = load double, ptr %7, align 8
  %8 = getelementptr i8, ptr %6, i64 8
  store double %.724.us.1.1.peel, ptr %8, align 8
  %9 = getelementptr i8, ptr %5, i64 16
  %.724.us.2.1.peel = load double, ptr %9, align 8
  %10 = getelementptr i8, ptr %6, i64 16
  store double %.724.us.2.1.peel, ptr %10, align 8
  %.idx = shl i64 %arg.room.5.2, 4
  %11 = getelementptr i8, ptr %0, i64 %.idx
  %.idx1 = shl i64 %arg.o.5.2, 4
  %12 = getelementptr i8, ptr %arg.o.4, i64 %.idx1
  %.724.us.2354.peel = load double, ptr %11, align 8
  store double %.724.us.2354.peel, ptr %12, align 8
  %13 = getelementptr i8, ptr %11, i64 8
  %.724.us.1.2.peel = load double, ptr %13, align 8
  %14 = getelementptr i8, ptr %12, i64 8
  store double %.724.us.1.2.peel, ptr %14, align 8
  %15 = getelementptr i8, ptr %11, i64 16
  %.724.us.2.2.peel = load double, ptr %15, align 8
  %16 = getelementptr i8, ptr %12, i64 16
  store double %.724.us.2.2.peel, ptr %16, align 8
  %.idx356 = mul i64 %arg.room.5.2, 24
  %17 = getelementptr i8, ptr %0, i64 %.idx356
  %.idx2 = mul i64 %arg.o.5.2, 24
  %18 = getelementptr i8, ptr %arg.o.4, i64 %.idx2
  %.724.us.3.peel = load double, ptr %17, align 8
  store double %.724.us.3.peel, ptr %18, align 8
  %19 = getelementptr i8, ptr %17, i64 8
  %.724.us.1.3.peel = load double, ptr %19, align 8
  %20 = getelementptr i8, ptr %18, i64 8
  store double %.724.us.1.3.peel, ptr %20, align 8
  %21 = getelementptr i8, ptr %17, i64 16
  %.724.us.2.3.peel = load double, ptr %21, align 8
  %22 = getelementptr i8, ptr %18, i64 16
  store double %.724.us.2.3.peel, ptr %22, align 8
  %.idx357 = shl i64 %arg.room.5.2, 5
  %23 = getelementptr i8, ptr %0, i64 %.idx357
  %.idx3 = shl i64 %arg.o.5.2, 5
  %24 = getelementptr i8, ptr %arg.o.4, i64 %.idx3
  %.724.us.4.peel = load double, ptr %23, align 8
  store double %.724.us.4.peel, ptr %24, align 8
  %25 = getelementptr i8, ptr %23, i64 8
  %.724.us.1.4.peel = load double, ptr %25, align 8
  %26 = getelementptr i8, ptr %24, i64 8
  store double %.724.us.1.4.peel, ptr %26, align 8
  %27 = getelementptr i8, ptr %23, i64 16
  %.724.us.2.4.peel = load double, ptr %27, align 8
  %28 = getelementptr i8, ptr %24, i64 16
  store double %.724.us.2.4.peel, ptr %28, align 8
  %.idx358 = mul i64 %arg.room.5.2, 40
  %29 = getelementptr i8, ptr %0, i64 %.idx358
  %.idx4 = mul i64 %arg.o.5.2, 40
  %30 = getelementptr i8, ptr %arg.o.4, i64 %.idx4
  %.724.us.5.peel = load double, ptr %29, align 8
  store double %.724.us.5.peel, ptr %30, align 8
  %31 = getelementptr i8, ptr %29, i64 8
  %.724.us.1.5.peel = load double, ptr %31, align 8
  %32 = getelementptr i8, ptr %30, i64 8
  store double %.724.us.1.5.peel, ptr %32, align 8
  %33 = getelementptr i8, ptr %29, i64 16
  %.724.us.2.5.peel = load double, ptr %33, align 8
  %34 = getelementptr i8, ptr %30, i64 16
  store double %.724.us.2.5.peel, ptr %34, align 8
  %.idx359 = mul i64 %arg.room.5.2, 48
  %35 = getelementptr i8, ptr %0, i64 %.idx359
  %.idx5 = mul i64 %arg.o.5.2, 48
  %36 = getelementptr i8, ptr %arg.o.4, i64 %.idx5
  %.724.us.6.peel = load double, ptr %35, align 8
  store double %.724.us.6.peel, ptr %36, align 8
  %37 = getelementptr i8, ptr %35, i64 8
  %.724.us.1.6.peel = load double, ptr %37, align 8
  %38 = getelementptr i8, ptr %36, i64 8
  store double %.724.us.1.6.peel, ptr %38, align 8
  %39 = getelementptr i8, ptr %35, i64 16
  %.724.us.2.6.peel = load double, ptr %39, align 8
  %40 = getelementptr i8, ptr %36, i64 16
  store double %.724.us.2.6.peel, ptr %40, align 8
  %exitcond.peel.not = icmp eq i64 %arg.q.5.0, 1
  br i1 %exitcond.peel.not, label %B224, label %B62.preheader

B62.preheader:                                    ; preds = %B62.lr.ph
  %41 = shl i64 %arg.o.5.1, 3
  %42 = mul i64 %41, %arg.o.5.2
  %43 = add nsw i64 %arg.q.5.0, -1
  %44 = shl i64 %arg.o.5.2, 3
  %sunkaddr39 = shl i64 %arg.room.5.2, 3
  %sunkaddr40 = getelementptr i8, ptr %0, i64 %sunkaddr39
  %sunkaddr43 = getelementptr i8, ptr %sunkaddr40, i64 8
  %sunkaddr46 = getelementptr i8, ptr %sunkaddr40, i64 16
  br label %B62

B62:                                              ; preds = %B62, %B62.preheader
  %lsr.iv17 = phi i64 [ %43, %B62.preheader ], [ %lsr.iv.next, %B62 ]
  %arg.q.4.pn = phi ptr [ %arg.q.4, %B62.preheader ], [ %lsr.iv15, %B62 ]
  %arg.o.4.pn = phi ptr [ %arg.o.4, %B62.preheader ], [ %lsr.iv, %B62 ]
  %lsr.iv15 = getelementptr i8, ptr %arg.q.4.pn, i64 %arg.q.6.0
  call fastcc void @part.1(ptr nonnull %.363, ptr %arg.chain.4, i64 %arg.chain.5.1, ptr %arg.X_WO.4, i64 %arg.X_WO.6.0, i64 %arg.X_WO.6.1, ptr %arg.ride.4, i64 %arg.ride.6.0, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr nonnull %arg.room.4, i64 %arg.room.5.1, i64 %arg.room.5.2, ptr %lsr.iv15, i64 %arg.q.5.1, i64 %arg.q.6.1)
  %lsr.iv = getelementptr i8, ptr %arg.o.4.pn, i64 %42
  %.724.us = load double, ptr %0, align 8
  store double %.724.us, ptr %lsr.iv, align 8
  %.724.us.1 = load double, ptr %1, align 8
  %scevgep18 = getelementptr i8, ptr %lsr.iv, i64 8
  store double %.724.us.1, ptr %scevgep18, align 8
  %.724.us.2 = load double, ptr %3, align 8
  %scevgep19 = getelementptr i8, ptr %lsr.iv, i64 16
  store double %.724.us.2, ptr %scevgep19, align 8
  %.724.us.1353 = load double, ptr %sunkaddr40, align 8
  %scevgep20 = getelementptr i8, ptr %lsr.iv, i64 %44
  store double %.724.us.1353, ptr %scevgep20, align 8
  %.724.us.1.1 = load double, ptr %sunkaddr43, align 8
  %sunkaddr84 = getelementptr i8, ptr %scevgep20, i64 8
  store double %.724.us.1.1, ptr %sunkaddr84, align 8
  %.724.us.2.1 = load double, ptr %sunkaddr46, align 8
  %sunkaddr87 = getelementptr i8, ptr %scevgep20, i64 16
  store double %.724.us.2.1, ptr %sunkaddr87, align 8
  %.724.us.2354 = load double, ptr %11, align 8
  %scevgep23 = getelementptr i8, ptr %scevgep20, i64 %44
  store double %.724.us.2354, ptr %scevgep23, align 8
  %.724.us.1.2 = load double, ptr %13, align 8
  %sunkaddr92 = getelementptr i8, ptr %scevgep23, i64 8
  store double %.724.us.1.2, ptr %sunkaddr92, align 8
  %.724.us.2.2 = load double, ptr %15, align 8
  %sunkaddr95 = getelementptr i8, ptr %scevgep23, i64 16
  store double %.724.us.2.2, ptr %sunkaddr95, align 8
  %.724.us.3 = load double, ptr %17, align 8
  %scevgep26 = getelementptr i8, ptr %scevgep23, i64 %44
  store double %.724.us.3, ptr %scevgep26, align 8
  %.724.us.1.3 = load double, ptr %19, align 8
  %sunkaddr100 = getelementptr i8, ptr %scevgep26, i64 8
  store double %.724.us.1.3, ptr %sunkaddr100, align 8
  %.724.us.2.3 = load double, ptr %21, align 8
  %sunkaddr103 = getelementptr i8, ptr %scevgep26, i64 16
  store double %.724.us.2.3, ptr %sunkaddr103, align 8
  %.724.us.4 = load double, ptr %23, align 8
  %scevgep29 = getelementptr i8, ptr %scevgep26, i64 %44
  store double %.724.us.4, ptr %scevgep29, align 8
  %.724.us.1.4 = load double, ptr %25, align 8
  %sunkaddr108 = getelementptr i8, ptr %scevgep29, i64 8
  store double %.724.us.1.4, ptr %sunkaddr108, align 8
  %.724.us.2.4 = load double, ptr %27, align 8
  %sunkaddr111 = getelementptr i8, ptr %scevgep29, i64 16
  store double %.724.us.2.4, ptr %sunkaddr111, align 8
  %.724.us.5 = load double, ptr %29, align 8
  %scevgep32 = getelementptr i8, ptr %scevgep29, i64 %44
  store double %.724.us.5, ptr %scevgep32, align 8
  %.724.us.1.5 = load double, ptr %31, align 8
  %sunkaddr116 = getelementptr i8, ptr %scevgep32, i64 8
  store double %.724.us.1.5, ptr %sunkaddr116, align 8
  %.724.us.2.5 = load double, ptr %33, align 8
  %sunkaddr119 = getelementptr i8, ptr %scevgep32, i64 16
  store double %.724.us.2.5, ptr %sunkaddr119, align 8
  %.724.us.6 = load double, ptr %35, align 8
  %sunkaddr69 = getelementptr i8, ptr %scevgep32, i64 %44
  store double %.724.us.6, ptr %sunkaddr69, align 8
  %.724.us.1.6 = load double, ptr %37, align 8
  %sunkaddr74 = getelementptr i8, ptr %sunkaddr69, i64 8
  store double %.724.us.1.6, ptr %sunkaddr74, align 8
  %.724.us.2.6 = load double, ptr %39, align 8
  %sunkaddr79 = getelementptr i8, ptr %sunkaddr69, i64 16
  store double %.724.us.2.6, ptr %sunkaddr79, align 8
  %lsr.iv.next = add nsw i64 %lsr.iv17, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not, label %B224, label %B62, !llvm.loop !5

B224:                                             ; preds = %B62, %B62.lr.ph, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @part.1(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.chain.4, i64 %arg.chain.5.1, ptr readonly captures(none) %arg.X_WO.4, i64 %arg.X_WO.6.0, i64 %arg.X_WO.6.1, ptr readonly captures(none) %arg.ride.4, i64 %arg.ride.6.0, ptr readonly captures(none) %arg.X_6T.4, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr initializes((0, 24)) %arg.room.4, i64 %arg.room.5.1, i64 %arg.room.5.2, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.6.0) unnamed_addr #0 {
B0.endif.endif:
  %.162 = mul i64 %arg.room.5.2, %arg.room.5.1
  %.342.idx = shl i64 %.162, 4
  %.342 = getelementptr i8, ptr %arg.room.4, i64 %.342.idx
  %.441 = add nsw i64 %arg.q.5.0, -6
  %.616 = mul i64 %arg.X_WO.6.1, 3
  %invariant.gep1129 = getelementptr i8, ptr %arg.X_WO.4, i64 %.616
  %.678.not = icmp eq i64 %.441, 0
  %.621.us = load double, ptr %invariant.gep1129, align 8
  store double %.621.us, ptr %.342, align 8
  br i1 %.678.not, label %B120.us.preheader, label %B120.preheader

B120.preheader:                                   ; preds = %B0.endif.endif
  %.766 = load double, ptr %arg.ride.4, align 8
  %.797 = load double, ptr %arg.q.4, align 8
  %.798 = fmul double %.766, %.797
  %.799 = fadd double %.621.us, %.798
  store double %.799, ptr %.342, align 8
  %.1022 = load double, ptr %arg.X_WO.4, align 8
  store double %.1022, ptr %arg.room.4, align 8
  %.1020.1 = getelementptr i8, ptr %arg.X_WO.4, i64 %arg.X_WO.6.1
  %.1022.1 = load double, ptr %.1020.1, align 8
  %gep.1 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  store double %.1022.1, ptr %gep.1, align 8
  %.1017.2 = shl i64 %arg.X_WO.6.1, 1
  %.1020.2 = getelementptr i8, ptr %arg.X_WO.4, i64 %.1017.2
  %.1022.2 = load double, ptr %.1020.2, align 8
  %.1072.2 = shl i64 %arg.room.5.2, 1
  %gep.2 = getelementptr double, ptr %arg.room.4, i64 %.1072.2
  store double %.1022.2, ptr %gep.2, align 8
  %gep1130.1 = getelementptr i8, ptr %invariant.gep1129, i64 %arg.X_WO.6.0
  %.621.1 = load double, ptr %gep1130.1, align 8
  %.675.1 = getelementptr i8, ptr %.342, i64 8
  store double %.621.1, ptr %.675.1, align 8
  %.764.1 = getelementptr i8, ptr %arg.ride.4, i64 %arg.ride.6.0
  %.766.1 = load double, ptr %.764.1, align 8
  %.797.1 = load double, ptr %arg.q.4, align 8
  %.798.1 = fmul double %.766.1, %.797.1
  %.799.1 = fadd double %.621.1, %.798.1
  store double %.799.1, ptr %.675.1, align 8
  %0 = getelementptr i8, ptr %arg.X_WO.4, i64 %arg.X_WO.6.0
  %invariant.gep.1 = getelementptr i8, ptr %arg.room.4, i64 8
  %.1022.11190 = load double, ptr %0, align 8
  store double %.1022.11190, ptr %invariant.gep.1, align 8
  %.1020.1.1 = getelementptr i8, ptr %0, i64 %arg.X_WO.6.1
  %.1022.1.1 = load double, ptr %.1020.1.1, align 8
  %gep.1.1 = getelementptr double, ptr %invariant.gep.1, i64 %arg.room.5.2
  store double %.1022.1.1, ptr %gep.1.1, align 8
  %.1020.2.1 = getelementptr i8, ptr %0, i64 %.1017.2
  %.1022.2.1 = load double, ptr %.1020.2.1, align 8
  %gep.2.1 = getelementptr double, ptr %invariant.gep.1, i64 %.1072.2
  store double %.1022.2.1, ptr %gep.2.1, align 8
  %.615.2 = shl i64 %arg.X_WO.6.0, 1
  %gep1130.2 = getelementptr i8, ptr %invariant.gep1129, i64 %.615.2
  %.621.2 = load double, ptr %gep1130.2, align 8
  %.675.2 = getelementptr i8, ptr %.342, i64 16
  store double %.621.2, ptr %.675.2, align 8
  %.762.2 = shl i64 %arg.ride.6.0, 1
  %.764.2 = getelementptr i8, ptr %arg.ride.4, i64 %.762.2
  %.766.2 = load double, ptr %.764.2, align 8
  %.797.2 = load double, ptr %arg.q.4, align 8
  %.798.2 = fmul double %.766.2, %.797.2
  %.799.2 = fadd double %.621.2, %.798.2
  store double %.799.2, ptr %.675.2, align 8
  br label %B616.endif.2.peel.next

B120.us.preheader:                                ; preds = %B0.endif.endif
  %.1022.us = load double, ptr %arg.X_WO.4, align 8
  store double %.1022.us, ptr %arg.room.4, align 8
  %.1020.us.1 = getelementptr i8, ptr %arg.X_WO.4, i64 %arg.X_WO.6.1
  %.1022.us.1 = load double, ptr %.1020.us.1, align 8
  %gep.us.1 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  store double %.1022.us.1, ptr %gep.us.1, align 8
  %.1017.us.2 = shl i64 %arg.X_WO.6.1, 1
  %.1020.us.2 = getelementptr i8, ptr %arg.X_WO.4, i64 %.1017.us.2
  %.1022.us.2 = load double, ptr %.1020.us.2, align 8
  %.1072.us.2 = shl i64 %arg.room.5.2, 1
  %gep.us.2 = getelementptr double, ptr %arg.room.4, i64 %.1072.us.2
  store double %.1022.us.2, ptr %gep.us.2, align 8
  %gep1130.us.1 = getelementptr i8, ptr %invariant.gep1129, i64 %arg.X_WO.6.0
  %.621.us.1 = load double, ptr %gep1130.us.1, align 8
  %.675.us.1 = getelementptr i8, ptr %.342, i64 8
  store double %.621.us.1, ptr %.675.us.1, align 8
  %1 = getelementptr i8, ptr %arg.X_WO.4, i64 %arg.X_WO.6.0
  %invariant.gep.us.1 = getelementptr i8, ptr %arg.room.4, i64 8
  %.1022.us.11192 = load double, ptr %1, align 8
  store double %.1022.us.11192, ptr %invariant.gep.us.1, align 8
  %.1020.us.1.1 = getelementptr i8, ptr %1, i64 %arg.X_WO.6.1
  %.1022.us.1.1 = load double, ptr %.1020.us.1.1, align 8
  %gep.us.1.1 = getelementptr double, ptr %invariant.gep.us.1, i64 %arg.room.5.2
  store double %.1022.us.1.1, ptr %gep.us.1.1, align 8
  %.1020.us.2.1 = getelementptr i8, ptr %1, i64 %.1017.us.2
  %.1022.us.2.1 = load double, ptr %.1020.us.2.1, align 8
  %gep.us.2.1 = getelementptr double, ptr %invariant.gep.us.1, i64 %.1072.us.2
  store double %.1022.us.2.1, ptr %gep.us.2.1, align 8
  %.615.us.2 = shl i64 %arg.X_WO.6.0, 1
  %gep1130.us.2 = getelementptr i8, ptr %invariant.gep1129, i64 %.615.us.2
  %.621.us.2 = load double, ptr %gep1130.us.2, align 8
  %.675.us.2 = getelementptr i8, ptr %.342, i64 16
  store double %.621.us.2, ptr %.675.us.2, align 8
  br label %B616.endif.2.peel.next

common.ret:                                       ; preds = %B616.endif.2
  %.idx = mul i64 %arg.room.5.2, 40
  %2 = getelementptr i8, ptr %.342, i64 %.idx
  %.3025 = mul i64 %arg.X_6T.6.1, 3
  %.3028 = getelementptr i8, ptr %arg.X_6T.4, i64 %.3025
  %3 = getelementptr i8, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0
  %.3138 = getelementptr i8, ptr %3, i64 %.3025
  %.3244 = shl i64 %arg.X_6T.6.0, 1
  %4 = getelementptr i8, ptr %arg.X_6T.4, i64 %.3244
  %.3248 = getelementptr i8, ptr %4, i64 %.3025
  %.idx1122 = mul i64 %arg.room.5.2, 48
  %5 = getelementptr i8, ptr %.342, i64 %.idx1122
  %.2922 = load double, ptr %2, align 8
  %.2976 = load double, ptr %arg.room.4, align 8
  %.3030 = load double, ptr %.3028, align 8
  %.3031 = fmul double %.2976, %.3030
  %.3032 = fadd double %.2922, %.3031
  %.3086 = load double, ptr %sunkaddr28, align 8
  %.3140 = load double, ptr %.3138, align 8
  %.3141 = fmul double %.3086, %.3140
  %.3142 = fadd double %.3032, %.3141
  %.3196 = load double, ptr %8, align 8
  %.3250 = load double, ptr %.3248, align 8
  %.3251 = fmul double %.3196, %.3250
  %.3252 = fadd double %.3142, %.3251
  store double %.3252, ptr %5, align 8
  %.2921.1 = getelementptr i8, ptr %2, i64 8
  %.2922.1 = load double, ptr %.2921.1, align 8
  %.2976.1 = load double, ptr %.1904.1, align 8
  %.3030.1 = load double, ptr %.3028, align 8
  %.3031.1 = fmul double %.2976.1, %.3030.1
  %.3032.1 = fadd double %.2922.1, %.3031.1
  %.3086.1 = load double, ptr %sunkaddr33, align 8
  %.3140.1 = load double, ptr %.3138, align 8
  %.3141.1 = fmul double %.3086.1, %.3140.1
  %.3142.1 = fadd double %.3032.1, %.3141.1
  %.3196.1 = load double, ptr %.2126.1, align 8
  %.3250.1 = load double, ptr %.3248, align 8
  %.3251.1 = fmul double %.3196.1, %.3250.1
  %.3252.1 = fadd double %.3142.1, %.3251.1
  %.3305.1 = getelementptr i8, ptr %5, i64 8
  store double %.3252.1, ptr %.3305.1, align 8
  %.2921.2 = getelementptr i8, ptr %2, i64 16
  %.2922.2 = load double, ptr %.2921.2, align 8
  %.2976.2 = load double, ptr %invariant.gep.2, align 8
  %.3030.2 = load double, ptr %.3028, align 8
  %.3031.2 = fmul double %.2976.2, %.3030.2
  %.3032.2 = fadd double %.2922.2, %.3031.2
  %.3086.2 = load double, ptr %sunkaddr39, align 8
  %.3140.2 = load double, ptr %.3138, align 8
  %.3141.2 = fmul double %.3086.2, %.3140.2
  %.3142.2 = fadd double %.3032.2, %.3141.2
  %.3196.2 = load double, ptr %.2126.2, align 8
  %.3250.2 = load double, ptr %.3248, align 8
  %.3251.2 = fmul double %.3196.2, %.3250.2
  %.3252.2 = fadd double %.3142.2, %.3251.2
  %.3305.2 = getelementptr i8, ptr %5, i64 16
  store double %.3252.2, ptr %.3305.2, align 8
  store ptr null, ptr %retptr, align 8
  ret void

B616.endif.2.peel.next:                           ; preds = %B120.us.preheader, %B120.preheader
  %.615.2.sink = phi i64 [ %.615.2, %B120.preheader ], [ %.615.us.2, %B120.us.preheader ]
  %.1017.2.sink = phi i64 [ %.1017.2, %B120.preheader ], [ %.1017.us.2, %B120.us.preheader ]
  %.1072.2.sink = phi i64 [ %.1072.2, %B120.preheader ], [ %.1072.us.2, %B120.us.preheader ]
  %6 = getelementptr i8, ptr %arg.X_WO.4, i64 %.615.2.sink
  %invariant.gep.2 = getelementptr i8, ptr %arg.room.4, i64 16
  %.1022.21191 = load double, ptr %6, align 8
  store double %.1022.21191, ptr %invariant.gep.2, align 8
  %.1020.1.2 = getelementptr i8, ptr %6, i64 %arg.X_WO.6.1
  %.1022.1.2 = load double, ptr %.1020.1.2, align 8
  %gep.1.2 = getelementptr double, ptr %invariant.gep.2, i64 %arg.room.5.2
  store double %.1022.1.2, ptr %gep.1.2, align 8
  %.1020.2.2 = getelementptr i8, ptr %6, i64 %.1017.2.sink
  %.1022.2.2 = load double, ptr %.1020.2.2, align 8
  %gep.2.2 = getelementptr double, ptr %invariant.gep.2, i64 %.1072.2.sink
  store double %.1022.2.2, ptr %gep.2.2, align 8
  %7 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  %.idx1123 = shl i64 %arg.room.5.2, 4
  %8 = getelementptr i8, ptr %arg.room.4, i64 %.idx1123
  %.1904.1 = getelementptr i8, ptr %arg.room.4, i64 8
  %.2015.1 = getelementptr i8, ptr %7, i64 8
  %.2126.1 = getelementptr i8, ptr %8, i64 8
  %.2015.2 = getelementptr i8, ptr %7, i64 16
  %.2126.2 = getelementptr i8, ptr %8, i64 16
  %.1281.peel = getelementptr i8, ptr %arg.chain.4, i64 8
  %.1282.peel = load double, ptr %.1281.peel, align 8
  %.1299.peel = icmp slt i64 %arg.q.5.0, 6
  %.1300.peel = select i1 %.1299.peel, i64 %arg.q.5.0, i64 0
  %.1301.peel = add i64 %.1300.peel, %.441
  %.1312.peel = mul i64 %.1301.peel, %arg.q.6.0
  %.1314.peel = getelementptr i8, ptr %arg.q.4, i64 %.1312.peel
  %.1316.peel = load double, ptr %.1314.peel, align 8
  %.1317.peel = fmul double %.1282.peel, %.1316.peel
  %.1371.peel = getelementptr i8, ptr %arg.chain.4, i64 16
  %.1372.peel = load double, ptr %.1371.peel, align 8
  %.1373.peel = fadd double %.1317.peel, %.1372.peel
  %.1427.peel = getelementptr i8, ptr %arg.chain.4, i64 48
  %.1428.peel = load double, ptr %.1427.peel, align 8
  %.1430.peel = fmul double %.1428.peel, 0.000000e+00
  %.1433.peel = fsub double %.1373.peel, %.1430.peel
  %.1471.peel = tail call double @llvm.cos.f64(double %.1433.peel)
  %.1472.peel = tail call double @llvm.sin.f64(double %.1433.peel)
  %.1533.peel = load double, ptr %arg.chain.4, align 8
  %.5.i.peel = fptosi double %.1533.peel to i64
  %.1562.peel = add nsw i64 %.5.i.peel, 1
  %.1582.peel = srem i64 %.1562.peel, 3
  %.1584.peel = icmp slt i64 %.1582.peel, 0
  %.1593.peel = add nsw i64 %.1582.peel, 3
  %.1573.1.peel = select i1 %.1584.peel, i64 %.1593.peel, i64 %.1582.peel
  %.1604.peel = add nsw i64 %.5.i.peel, 2
  %.1624.peel = srem i64 %.1604.peel, 3
  %.1626.peel = icmp slt i64 %.1624.peel, 0
  %.1635.peel = add nsw i64 %.1624.peel, 3
  %.1615.1.peel = select i1 %.1626.peel, i64 %.1635.peel, i64 %.1624.peel
  %.1959.peel = getelementptr i8, ptr %arg.chain.4, i64 24
  %.2070.peel = getelementptr i8, ptr %arg.chain.4, i64 32
  %.2181.peel = getelementptr i8, ptr %arg.chain.4, i64 40
  %.2265.peel = icmp slt i64 %.5.i.peel, 0
  %.2266.peel = select i1 %.2265.peel, i64 %arg.room.5.1, i64 0
  %.2267.peel = add i64 %.2266.peel, %.5.i.peel
  %.2287.peel = mul i64 %.2267.peel, %arg.room.5.2
  %9 = getelementptr double, ptr %arg.room.4, i64 %.2287.peel
  %.1849.peel = load double, ptr %.342, align 8
  %.1905.peel = load double, ptr %arg.room.4, align 8
  %.1960.peel = load double, ptr %.1959.peel, align 8
  %.1961.peel = fmul double %.1905.peel, %.1960.peel
  %.1962.peel = fadd double %.1849.peel, %.1961.peel
  %.2016.peel = load double, ptr %7, align 8
  %.2071.peel = load double, ptr %.2070.peel, align 8
  %.2072.peel = fmul double %.2016.peel, %.2071.peel
  %.2073.peel = fadd double %.1962.peel, %.2072.peel
  %.2127.peel = load double, ptr %8, align 8
  %.2182.peel = load double, ptr %.2181.peel, align 8
  %.2183.peel = fmul double %.2127.peel, %.2182.peel
  %.2184.peel = fadd double %.2073.peel, %.2183.peel
  store double %.2184.peel, ptr %.342, align 8
  %.2292.peel = load double, ptr %9, align 8
  %sunkaddr54 = shl i64 %.162, 3
  %sunkaddr55 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr54
  store double %.2292.peel, ptr %sunkaddr55, align 8
  %sunkaddr24 = getelementptr i8, ptr %.342, i64 8
  %.1849.1.peel = load double, ptr %sunkaddr24, align 8
  %.1905.1.peel = load double, ptr %.1904.1, align 8
  %.1960.1.peel = load double, ptr %.1959.peel, align 8
  %.1961.1.peel = fmul double %.1905.1.peel, %.1960.1.peel
  %.1962.1.peel = fadd double %.1849.1.peel, %.1961.1.peel
  %.2016.1.peel = load double, ptr %.2015.1, align 8
  %.2071.1.peel = load double, ptr %.2070.peel, align 8
  %.2072.1.peel = fmul double %.2016.1.peel, %.2071.1.peel
  %.2073.1.peel = fadd double %.1962.1.peel, %.2072.1.peel
  %.2127.1.peel = load double, ptr %.2126.1, align 8
  %.2182.1.peel = load double, ptr %.2181.peel, align 8
  %.2183.1.peel = fmul double %.2127.1.peel, %.2182.1.peel
  %.2184.1.peel = fadd double %.2073.1.peel, %.2183.1.peel
  store double %.2184.1.peel, ptr %sunkaddr24, align 8
  %.2291.1.peel = getelementptr i8, ptr %9, i64 8
  %.2292.1.peel = load double, ptr %.2291.1.peel, align 8
  %sunkaddr60 = getelementptr i8, ptr %sunkaddr55, i64 8
  store double %.2292.1.peel, ptr %sunkaddr60, align 8
  %sunkaddr26 = getelementptr i8, ptr %.342, i64 16
  %.1849.2.peel = load double, ptr %sunkaddr26, align 8
  %.1905.2.peel = load double, ptr %invariant.gep.2, align 8
  %.1960.2.peel = load double, ptr %.1959.peel, align 8
  %.1961.2.peel = fmul double %.1905.2.peel, %.1960.2.peel
  %.1962.2.peel = fadd double %.1849.2.peel, %.1961.2.peel
  %.2016.2.peel = load double, ptr %.2015.2, align 8
  %.2071.2.peel = load double, ptr %.2070.peel, align 8
  %.2072.2.peel = fmul double %.2016.2.peel, %.2071.2.peel
  %.2073.2.peel = fadd double %.1962.2.peel, %.2072.2.peel
  %.2127.2.peel = load double, ptr %.2126.2, align 8
  %.2182.2.peel = load double, ptr %.2181.peel, align 8
  %.2183.2.peel = fmul double %.2127.2.peel, %.2182.2.peel
  %.2184.2.peel = fadd double %.2073.2.peel, %.2183.2.peel
  store double %.2184.2.peel, ptr %sunkaddr26, align 8
  %.2291.2.peel = getelementptr i8, ptr %9, i64 16
  %.2292.2.peel = load double, ptr %.2291.2.peel, align 8
  %sunkaddr65 = getelementptr i8, ptr %sunkaddr55, i64 16
  store double %.2292.2.peel, ptr %sunkaddr65, align 8
  %.2501.peel = icmp slt i64 %.1573.1.peel, 0
  %.2502.peel = select i1 %.2501.peel, i64 %arg.room.5.1, i64 0
  %.2503.peel = add i64 %.2502.peel, %.1573.1.peel
  %.2523.peel = mul i64 %.2503.peel, %arg.room.5.2
  %10 = getelementptr double, ptr %arg.room.4, i64 %.2523.peel
  %.2556.peel = icmp slt i64 %.1615.1.peel, 0
  %.2557.peel = select i1 %.2556.peel, i64 %arg.room.5.1, i64 0
  %.2558.peel = add i64 %.2557.peel, %.1615.1.peel
  %.2578.peel = mul i64 %.2558.peel, %arg.room.5.2
  %11 = getelementptr double, ptr %arg.room.4, i64 %.2578.peel
  %.2528.peel = load double, ptr %10, align 8
  %.2583.peel = load double, ptr %11, align 8
  %.2587.peel = fmul double %.1471.peel, %.2528.peel
  %.2589.peel = fmul double %.1472.peel, %.2583.peel
  %.2590.peel = fadd double %.2587.peel, %.2589.peel
  %.2592.peel = fmul double %.1471.peel, %.2583.peel
  %.2594.peel = fmul double %.1472.peel, %.2528.peel
  %.2595.peel = fsub double %.2592.peel, %.2594.peel
  store double %.2590.peel, ptr %10, align 8
  store double %.2595.peel, ptr %11, align 8
  %.2527.1.peel = getelementptr i8, ptr %10, i64 8
  %.2528.1.peel = load double, ptr %.2527.1.peel, align 8
  %.2582.1.peel = getelementptr i8, ptr %11, i64 8
  %.2583.1.peel = load double, ptr %.2582.1.peel, align 8
  %.2587.1.peel = fmul double %.1471.peel, %.2528.1.peel
  %.2589.1.peel = fmul double %.1472.peel, %.2583.1.peel
  %.2590.1.peel = fadd double %.2587.1.peel, %.2589.1.peel
  %.2592.1.peel = fmul double %.1471.peel, %.2583.1.peel
  %.2594.1.peel = fmul double %.1472.peel, %.2528.1.peel
  %.2595.1.peel = fsub double %.2592.1.peel, %.2594.1.peel
  store double %.2590.1.peel, ptr %.2527.1.peel, align 8
  store double %.2595.1.peel, ptr %.2582.1.peel, align 8
  %.2527.2.peel = getelementptr i8, ptr %10, i64 16
  %.2528.2.peel = load double, ptr %.2527.2.peel, align 8
  %.2582.2.peel = getelementptr i8, ptr %11, i64 16
  %.2583.2.peel = load double, ptr %.2582.2.peel, align 8
  %.2587.2.peel = fmul double %.1471.peel, %.2528.2.peel
  %.2589.2.peel = fmul double %.1472.peel, %.2583.2.peel
  %.2590.2.peel = fadd double %.2587.2.peel, %.2589.2.peel
  %.2592.2.peel = fmul double %.1471.peel, %.2583.2.peel
  %.2594.2.peel = fmul double %.1472.peel, %.2528.2.peel
  %.2595.2.peel = fsub double %.2592.2.peel, %.2594.2.peel
  store double %.2590.2.peel, ptr %.2527.2.peel, align 8
  store double %.2595.2.peel, ptr %.2582.2.peel, align 8
  %12 = add i64 %.342.idx, 16
  %13 = shl i64 %arg.room.5.2, 3
  %14 = shl i64 %arg.room.5.1, 4
  %15 = or disjoint i64 %14, 8
  %16 = mul i64 %15, %arg.room.5.2
  %17 = add i64 %16, 16
  %18 = shl i64 %arg.room.5.1, 3
  %19 = add i64 %18, 8
  %20 = mul i64 %19, %arg.room.5.2
  %21 = add i64 %20, 16
  %22 = shl i64 %arg.chain.5.1, 3
  %23 = getelementptr i8, ptr %arg.chain.4, i64 %22
  %scevgep26 = getelementptr i8, ptr %23, i64 48
  %24 = add i64 %arg.q.5.0, -5
  %sunkaddr28 = getelementptr i8, ptr %arg.room.4, i64 %13
  %sunkaddr33 = getelementptr i8, ptr %sunkaddr28, i64 8
  %sunkaddr39 = getelementptr i8, ptr %sunkaddr28, i64 16
  br label %B616.endif.2

B616.endif.2:                                     ; preds = %B616.endif.2, %B616.endif.2.peel.next
  %lsr.iv37 = phi i64 [ 5, %B616.endif.2.peel.next ], [ %lsr.iv.next38, %B616.endif.2 ]
  %lsr.iv35 = phi i64 [ %24, %B616.endif.2.peel.next ], [ %lsr.iv.next36, %B616.endif.2 ]
  %lsr.iv27 = phi ptr [ %scevgep26, %B616.endif.2.peel.next ], [ %scevgep28, %B616.endif.2 ]
  %lsr.iv19 = phi i64 [ %21, %B616.endif.2.peel.next ], [ %lsr.iv.next20, %B616.endif.2 ]
  %lsr.iv12 = phi i64 [ %17, %B616.endif.2.peel.next ], [ %lsr.iv.next13, %B616.endif.2 ]
  %lsr.iv = phi i64 [ %12, %B616.endif.2.peel.next ], [ %lsr.iv.next, %B616.endif.2 ]
  %before.2.01171 = phi double [ %.1316.peel, %B616.endif.2.peel.next ], [ %.1316, %B616.endif.2 ]
  %scevgep32 = getelementptr i8, ptr %lsr.iv27, i64 -48
  %scevgep34 = getelementptr i8, ptr %lsr.iv27, i64 -40
  %.1282 = load double, ptr %scevgep34, align 8
  %.1299 = icmp slt i64 %lsr.iv35, 0
  %.1300 = select i1 %.1299, i64 %arg.q.5.0, i64 0
  %25 = add i64 %.1300, %lsr.iv35
  %.1312 = mul i64 %25, %arg.q.6.0
  %.1314 = getelementptr i8, ptr %arg.q.4, i64 %.1312
  %.1316 = load double, ptr %.1314, align 8
  %.1317 = fmul double %.1282, %.1316
  %scevgep33 = getelementptr i8, ptr %lsr.iv27, i64 -32
  %.1372 = load double, ptr %scevgep33, align 8
  %.1373 = fadd double %.1317, %.1372
  %.1428 = load double, ptr %lsr.iv27, align 8
  %.1430 = fmul double %before.2.01171, %.1428
  %.1433 = fsub double %.1373, %.1430
  %.1471 = tail call double @llvm.cos.f64(double %.1433)
  %.1472 = tail call double @llvm.sin.f64(double %.1433)
  %.1533 = load double, ptr %scevgep32, align 8
  %.5.i = fptosi double %.1533 to i64
  %.1562 = add nsw i64 %.5.i, 1
  %.1582 = srem i64 %.1562, 3
  %.1584 = icmp slt i64 %.1582, 0
  %.1593 = add nsw i64 %.1582, 3
  %.1573.1 = select i1 %.1584, i64 %.1593, i64 %.1582
  %.1604 = add nsw i64 %.5.i, 2
  %.1624 = srem i64 %.1604, 3
  %.1626 = icmp slt i64 %.1624, 0
  %.1635 = add nsw i64 %.1624, 3
  %.1615.1 = select i1 %.1626, i64 %.1635, i64 %.1624
  %scevgep31 = getelementptr i8, ptr %lsr.iv27, i64 -24
  %scevgep30 = getelementptr i8, ptr %lsr.iv27, i64 -16
  %scevgep29 = getelementptr i8, ptr %lsr.iv27, i64 -8
  %.2265 = icmp slt i64 %.5.i, 0
  %.2266 = select i1 %.2265, i64 %arg.room.5.1, i64 0
  %.2267 = add i64 %.2266, %.5.i
  %.2287 = mul i64 %.2267, %arg.room.5.2
  %26 = getelementptr double, ptr %arg.room.4, i64 %.2287
  %scevgep10 = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv
  %scevgep11 = getelementptr i8, ptr %scevgep10, i64 -16
  %.1849 = load double, ptr %scevgep11, align 8
  %.1905 = load double, ptr %arg.room.4, align 8
  %.1960 = load double, ptr %scevgep31, align 8
  %.1961 = fmul double %.1905, %.1960
  %.1962 = fadd double %.1849, %.1961
  %.2016 = load double, ptr %sunkaddr28, align 8
  %.2071 = load double, ptr %scevgep30, align 8
  %.2072 = fmul double %.2016, %.2071
  %.2073 = fadd double %.1962, %.2072
  %.2127 = load double, ptr %8, align 8
  %.2182 = load double, ptr %scevgep29, align 8
  %.2183 = fmul double %.2127, %.2182
  %.2184 = fadd double %.2073, %.2183
  %scevgep14 = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv12
  %scevgep15 = getelementptr i8, ptr %scevgep14, i64 -16
  store double %.2184, ptr %scevgep15, align 8
  %.2292 = load double, ptr %26, align 8
  %scevgep21 = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv19
  %scevgep22 = getelementptr i8, ptr %scevgep21, i64 -16
  store double %.2292, ptr %scevgep22, align 8
  %scevgep7 = getelementptr i8, ptr %scevgep10, i64 -8
  %.1849.1 = load double, ptr %scevgep7, align 8
  %.1905.1 = load double, ptr %.1904.1, align 8
  %.1960.1 = load double, ptr %scevgep31, align 8
  %.1961.1 = fmul double %.1905.1, %.1960.1
  %.1962.1 = fadd double %.1849.1, %.1961.1
  %.2016.1 = load double, ptr %sunkaddr33, align 8
  %.2071.1 = load double, ptr %scevgep30, align 8
  %.2072.1 = fmul double %.2016.1, %.2071.1
  %.2073.1 = fadd double %.1962.1, %.2072.1
  %.2127.1 = load double, ptr %.2126.1, align 8
  %.2182.1 = load double, ptr %scevgep29, align 8
  %.2183.1 = fmul double %.2127.1, %.2182.1
  %.2184.1 = fadd double %.2073.1, %.2183.1
  %scevgep5 = getelementptr i8, ptr %scevgep14, i64 -8
  store double %.2184.1, ptr %scevgep5, align 8
  %.2291.1 = getelementptr i8, ptr %26, i64 8
  %.2292.1 = load double, ptr %.2291.1, align 8
  %scevgep3 = getelementptr i8, ptr %scevgep21, i64 -8
  store double %.2292.1, ptr %scevgep3, align 8
  %.1849.2 = load double, ptr %scevgep10, align 8
  %.1905.2 = load double, ptr %invariant.gep.2, align 8
  %.1960.2 = load double, ptr %scevgep31, align 8
  %.1961.2 = fmul double %.1905.2, %.1960.2
  %.1962.2 = fadd double %.1849.2, %.1961.2
  %.2016.2 = load double, ptr %sunkaddr39, align 8
  %.2071.2 = load double, ptr %scevgep30, align 8
  %.2072.2 = fmul double %.2016.2, %.2071.2
  %.2073.2 = fadd double %.1962.2, %.2072.2
  %.2127.2 = load double, ptr %.2126.2, align 8
  %.2182.2 = load double, ptr %scevgep29, align 8
  %.2183.2 = fmul double %.2127.2, %.2182.2
  %.2184.2 = fadd double %.2073.2, %.2183.2
  store double %.2184.2, ptr %scevgep14, align 8
  %.2291.2 = getelementptr i8, ptr %26, i64 16
  %.2292.2 = load double, ptr %.2291.2, align 8
  store double %.2292.2, ptr %scevgep21, align 8
  %.2501 = icmp slt i64 %.1573.1, 0
  %.2502 = select i1 %.2501, i64 %arg.room.5.1, i64 0
  %.2503 = add i64 %.2502, %.1573.1
  %.2523 = mul i64 %.2503, %arg.room.5.2
  %27 = getelementptr double, ptr %arg.room.4, i64 %.2523
  %.2556 = icmp slt i64 %.1615.1, 0
  %.2557 = select i1 %.2556, i64 %arg.room.5.1, i64 0
  %.2558 = add i64 %.2557, %.1615.1
  %.2578 = mul i64 %.2558, %arg.room.5.2
  %28 = getelementptr double, ptr %arg.room.4, i64 %.2578
  %.2528 = load double, ptr %27, align 8
  %.2583 = load double, ptr %28, align 8
  %.2587 = fmul double %.1471, %.2528
  %.2589 = fmul double %.1472, %.2583
  %.2590 = fadd double %.2587, %.2589
  %.2592 = fmul double %.1471, %.2583
  %.2594 = fmul double %.1472, %.2528
  %.2595 = fsub double %.2592, %.2594
  store double %.2590, ptr %27, align 8
  store double %.2595, ptr %28, align 8
  %.2527.1 = getelementptr i8, ptr %27, i64 8
  %.2528.1 = load double, ptr %.2527.1, align 8
  %.2582.1 = getelementptr i8, ptr %28, i64 8
  %.2583.1 = load double, ptr %.2582.1, align 8
  %.2587.1 = fmul double %.1471, %.2528.1
  %.2589.1 = fmul double %.1472, %.2583.1
  %.2590.1 = fadd double %.2587.1, %.2589.1
  %.2592.1 = fmul double %.1471, %.2583.1
  %.2594.1 = fmul double %.1472, %.2528.1
  %.2595.1 = fsub double %.2592.1, %.2594.1
  store double %.2590.1, ptr %.2527.1, align 8
  store double %.2595.1, ptr %.2582.1, align 8
  %.2527.2 = getelementptr i8, ptr %27, i64 16
  %.2528.2 = load double, ptr %.2527.2, align 8
  %.2582.2 = getelementptr i8, ptr %28, i64 16
  %.2583.2 = load double, ptr %.2582.2, align 8
  %.2587.2 = fmul double %.1471, %.2528.2
  %.2589.2 = fmul double %.1472, %.2583.2
  %.2590.2 = fadd double %.2587.2, %.2589.2
  %.2592.2 = fmul double %.1471, %.2583.2
  %.2594.2 = fmul double %.1472, %.2528.2
  %.2595.2 = fsub double %.2592.2, %.2594.2
  store double %.2590.2, ptr %.2527.2, align 8
  store double %.2595.2, ptr %.2582.2, align 8
  %lsr.iv.next = add i64 %lsr.iv, %13
  %lsr.iv.next13 = add i64 %lsr.iv12, %13
  %lsr.iv.next20 = add i64 %lsr.iv19, %13
  %scevgep28 = getelementptr i8, ptr %lsr.iv27, i64 %22
  %lsr.iv.next36 = add i64 %lsr.iv35, 1
  %lsr.iv.next38 = add nsw i64 %lsr.iv37, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next38, 0
  br i1 %exitcond.not, label %common.ret, label %B616.endif.2, !llvm.loop !6
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.jacobians(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.chain.0, ptr readnone captures(none) %arg.chain.1, i64 %arg.chain.2, i64 %arg.chain.3, ptr readonly captures(none) %arg.chain.4, i64 %arg.chain.5.0, i64 %arg.chain.5.1, i64 %arg.chain.6.0, i64 %arg.chain.6.1, ptr readnone captures(none) %arg.X_WO.0, ptr readnone captures(none) %arg.X_WO.1, i64 %arg.X_WO.2, i64 %arg.X_WO.3, ptr readonly captures(none) %arg.X_WO.4, i64 %arg.X_WO.5.0, i64 %arg.X_WO.5.1, i64 %arg.X_WO.6.0, i64 %arg.X_WO.6.1, ptr readnone captures(none) %arg.ride.0, ptr readnone captures(none) %arg.ride.1, i64 %arg.ride.2, i64 %arg.ride.3, ptr readonly captures(none) %arg.ride.4, i64 %arg.ride.5.0, i64 %arg.ride.6.0, ptr readnone captures(none) %arg.X_6T.0, ptr readnone captures(none) %arg.X_6T.1, i64 %arg.X_6T.2, i64 %arg.X_6T.3, ptr readonly captures(none) %arg.X_6T.4, i64 %arg.X_6T.5.0, i64 %arg.X_6T.5.1, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr readnone captures(none) %arg.room.0, ptr readnone captures(none) %arg.room.1, i64 %arg.room.2, i64 %arg.room.3, ptr %arg.room.4, i64 %arg.room.5.0, i64 %arg.room.5.1, i64 %arg.room.5.2, i64 %arg.room.6.0, i64 %arg.room.6.1, i64 %arg.room.6.2, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.6.0, i64 %arg.q.6.1, ptr readnone captures(none) %arg.J.0, ptr readnone captures(none) %arg.J.1, i64 %arg.J.2, i64 %arg.J.3, ptr captures(none) %arg.J.4, i64 %arg.J.5.0, i64 %arg.J.5.1, i64 %arg.J.5.2, i64 %arg.J.6.0, i64 %arg.J.6.1, i64 %arg.J.6.2) local_unnamed_addr #0 {
B0.endif:
  %.165 = add nsw i64 %arg.q.5.1, -6
  %.263368.not = icmp slt i64 %arg.q.5.0, 1
  br i1 %.263368.not, label %B292, label %B94.lr.ph

B94.lr.ph:                                        ; preds = %B0.endif
  %.480 = mul i64 %arg.J.5.2, %arg.J.5.1
  %.607 = icmp slt i64 %arg.q.5.1, 7
  %.569 = mul nsw i64 %.165, 3
  %storemerge348 = select i1 %.607, i64 0, i64 %.569
  %0 = add nuw i64 %arg.q.5.0, 2305843009213693951
  %1 = mul i64 %arg.J.5.1, %0
  %2 = add i64 %1, %storemerge348
  %3 = shl i64 %2, 3
  %4 = getelementptr i8, ptr %arg.J.4, i64 %3
  %scevgep = getelementptr i8, ptr %4, i64 24
  %5 = getelementptr i8, ptr %arg.ride.4, i64 %storemerge348
  %scevgep12 = getelementptr i8, ptr %5, i64 7
  %ident.check = icmp ne i64 %arg.J.5.2, 1
  %ident.check11 = icmp ne i64 %arg.ride.6.0, 1
  %6 = getelementptr i8, ptr %5, i64 -1
  %7 = icmp ult ptr %6, %arg.ride.4
  %8 = or i1 %ident.check11, %ident.check
  %9 = or i1 %7, %8
  %bound0 = icmp ult ptr %arg.J.4, %scevgep12
  %bound1 = icmp ult ptr %arg.ride.4, %scevgep
  %found.conflict = and i1 %bound0, %bound1
  %.mask = and i64 %arg.J.5.1, 1152921504606846976
  %stride.check = icmp ne i64 %.mask, 0
  %10 = or i1 %stride.check, %found.conflict
  %n.vec = and i64 %storemerge348, 9223372036854775806
  %scevgep16 = getelementptr i8, ptr %arg.J.4, i64 24
  %11 = shl i64 %.480, 3
  %12 = shl i64 %arg.J.5.2, 3
  %13 = shl i64 %arg.J.5.2, 4
  %14 = shl i64 %arg.ride.6.0, 1
  %.162.i = mul i64 %arg.room.5.2, %arg.room.5.1
  %.342.idx.i = shl i64 %.162.i, 4
  %.342.i = getelementptr i8, ptr %arg.room.4, i64 %.342.idx.i
  %.616.i = mul i64 %arg.X_WO.6.1, 3
  %invariant.gep1129.i = getelementptr i8, ptr %arg.X_WO.4, i64 %.616.i
  %.678.not.i = icmp eq i64 %.165, 0
  %invariant.gep.2.i = getelementptr i8, ptr %arg.room.4, i64 16
  %gep.1.2.i = getelementptr double, ptr %invariant.gep.2.i, i64 %arg.room.5.2
  %15 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  %.idx1123.i = shl i64 %arg.room.5.2, 4
  %16 = getelementptr i8, ptr %arg.room.4, i64 %.idx1123.i
  %.1904.1.i = getelementptr i8, ptr %arg.room.4, i64 8
  %.2015.1.i = getelementptr i8, ptr %15, i64 8
  %.2126.1.i = getelementptr i8, ptr %16, i64 8
  %.2015.2.i = getelementptr i8, ptr %15, i64 16
  %.2126.2.i = getelementptr i8, ptr %16, i64 16
  %.1281.peel.i = getelementptr i8, ptr %arg.chain.4, i64 8
  %.1299.peel.i = icmp slt i64 %arg.q.5.1, 6
  %.1300.peel.i = select i1 %.1299.peel.i, i64 %arg.q.5.1, i64 0
  %.1301.peel.i = add i64 %.1300.peel.i, %.165
  %.1312.peel.i = mul i64 %.1301.peel.i, %arg.q.6.1
  %.1371.peel.i = getelementptr i8, ptr %arg.chain.4, i64 16
  %.1427.peel.i = getelementptr i8, ptr %arg.chain.4, i64 48
  %.1959.peel.i = getelementptr i8, ptr %arg.chain.4, i64 24
  %.2070.peel.i = getelementptr i8, ptr %arg.chain.4, i64 32
  %.2181.peel.i = getelementptr i8, ptr %arg.chain.4, i64 40
  %sunkaddr54.i = shl i64 %.162.i, 3
  %sunkaddr55.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr54.i
  %sunkaddr24.i = getelementptr i8, ptr %.342.i, i64 8
  %sunkaddr60.i = getelementptr i8, ptr %sunkaddr55.i, i64 8
  %sunkaddr26.i = getelementptr i8, ptr %.342.i, i64 16
  %sunkaddr65.i = getelementptr i8, ptr %sunkaddr55.i, i64 16
  %17 = add i64 %.342.idx.i, 16
  %18 = shl i64 %arg.room.5.2, 3
  %19 = shl i64 %arg.room.5.1, 4
  %20 = or disjoint i64 %19, 8
  %21 = mul i64 %20, %arg.room.5.2
  %22 = add i64 %21, 16
  %23 = shl i64 %arg.room.5.1, 3
  %24 = add i64 %23, 8
  %25 = mul i64 %24, %arg.room.5.2
  %26 = add i64 %25, 16
  %27 = shl i64 %arg.chain.5.1, 3
  %28 = getelementptr i8, ptr %arg.chain.4, i64 %27
  %scevgep26.i = getelementptr i8, ptr %28, i64 48
  %29 = add i64 %arg.q.5.1, -5
  %sunkaddr28.i = getelementptr i8, ptr %arg.room.4, i64 %18
  %sunkaddr33.i = getelementptr i8, ptr %sunkaddr28.i, i64 8
  %sunkaddr39.i = getelementptr i8, ptr %sunkaddr28.i, i64 16
  %.idx.i = mul i64 %arg.room.5.2, 40
  %30 = getelementptr i8, ptr %.342.i, i64 %.idx.i
  %.3025.i = mul i64 %arg.X_6T.6.1, 3
  %.3028.i = getelementptr i8, ptr %arg.X_6T.4, i64 %.3025.i
  %31 = getelementptr i8, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0
  %.3138.i = getelementptr i8, ptr %31, i64 %.3025.i
  %.3244.i = shl i64 %arg.X_6T.6.0, 1
  %32 = getelementptr i8, ptr %arg.X_6T.4, i64 %.3244.i
  %.3248.i = getelementptr i8, ptr %32, i64 %.3025.i
  %.idx1122.i = mul i64 %arg.room.5.2, 48
  %33 = getelementptr i8, ptr %.342.i, i64 %.idx1122.i
  %.2921.1.i = getelementptr i8, ptr %30, i64 8
  %.3305.1.i = getelementptr i8, ptr %33, i64 8
  %.2921.2.i = getelementptr i8, ptr %30, i64 16
  %.3305.2.i = getelementptr i8, ptr %33, i64 16
  %.121.i = getelementptr double, ptr %arg.room.4, i64 %.162.i
  %34 = shl i64 %.165, 3
  %35 = add i64 %arg.J.5.2, %.165
  %36 = shl i64 %35, 3
  %37 = mul i64 %arg.J.5.2, 40
  %38 = shl i64 %arg.J.5.2, 5
  %39 = mul i64 %arg.J.5.2, 24
  %40 = icmp sgt i64 %storemerge348, 0
  %.1020.1.i = getelementptr i8, ptr %arg.X_WO.4, i64 %arg.X_WO.6.1
  %.1017.2.i = shl i64 %arg.X_WO.6.1, 1
  %.1020.2.i = getelementptr i8, ptr %arg.X_WO.4, i64 %.1017.2.i
  %.1072.2.i = shl i64 %arg.room.5.2, 1
  %gep.2.i = getelementptr double, ptr %arg.room.4, i64 %.1072.2.i
  %gep1130.1.i = getelementptr i8, ptr %invariant.gep1129.i, i64 %arg.X_WO.6.0
  %.764.1.i = getelementptr i8, ptr %arg.ride.4, i64 %arg.ride.6.0
  %41 = getelementptr i8, ptr %arg.X_WO.4, i64 %arg.X_WO.6.0
  %.1020.1.1.i = getelementptr i8, ptr %41, i64 %arg.X_WO.6.1
  %gep.1.1.i = getelementptr double, ptr %.1904.1.i, i64 %arg.room.5.2
  %.1020.2.1.i = getelementptr i8, ptr %41, i64 %.1017.2.i
  %gep.2.1.i = getelementptr double, ptr %.1904.1.i, i64 %.1072.2.i
  %.615.2.i = shl i64 %arg.X_WO.6.0, 1
  %gep1130.2.i = getelementptr i8, ptr %invariant.gep1129.i, i64 %.615.2.i
  %.764.2.i = getelementptr i8, ptr %arg.ride.4, i64 %14
  %42 = icmp samesign ult i64 %storemerge348, 10
  %brmerge = select i1 %42, i1 true, i1 %9
  %brmerge14 = select i1 %brmerge, i1 true, i1 %10
  %43 = icmp eq i64 %storemerge348, %n.vec
  %44 = and i64 %storemerge348, 1
  %45 = icmp eq i64 %44, 0
  %46 = getelementptr i8, ptr %arg.X_WO.4, i64 %.615.2.i
  %.1020.1.2.i = getelementptr i8, ptr %46, i64 %arg.X_WO.6.1
  %.1020.2.2.i = getelementptr i8, ptr %46, i64 %.1017.2.i
  %gep.2.2.i = getelementptr double, ptr %invariant.gep.2.i, i64 %.1072.2.i
  br label %B94

B92.loopexit:                                     ; preds = %B234, %B234.prol.loopexit, %middle.block, %part.2
  %scevgep17 = getelementptr i8, ptr %lsr.iv, i64 %11
  %scevgep26 = getelementptr i8, ptr %lsr.iv25, i64 %11
  %exitcond384.not = icmp eq i64 %.276, %arg.q.5.0
  br i1 %exitcond384.not, label %B292, label %B94

B94:                                              ; preds = %B92.loopexit, %B94.lr.ph
  %lsr.iv25 = phi ptr [ %arg.J.4, %B94.lr.ph ], [ %scevgep26, %B92.loopexit ]
  %lsr.iv = phi ptr [ %scevgep16, %B94.lr.ph ], [ %scevgep17, %B92.loopexit ]
  %.269358371 = phi i64 [ 0, %B94.lr.ph ], [ %.276, %B92.loopexit ]
  %.276 = add nuw nsw i64 %.269358371, 1
  %.342 = mul i64 %.269358371, %arg.q.6.0
  %.344 = getelementptr i8, ptr %arg.q.4, i64 %.342
  %.621.us.i = load double, ptr %invariant.gep1129.i, align 8, !noalias !7
  store double %.621.us.i, ptr %.342.i, align 8, !noalias !7
  br i1 %.678.not.i, label %B120.us.preheader.i, label %B120.preheader.i

B120.preheader.i:                                 ; preds = %B94
  %.766.i = load double, ptr %arg.ride.4, align 8, !noalias !7
  %.797.i = load double, ptr %.344, align 8, !noalias !7
  %.798.i = fmul double %.766.i, %.797.i
  %.799.i = fadd double %.621.us.i, %.798.i
  store double %.799.i, ptr %.342.i, align 8, !noalias !7
  %.1022.i = load double, ptr %arg.X_WO.4, align 8, !noalias !7
  store double %.1022.i, ptr %arg.room.4, align 8, !noalias !7
  %.1022.1.i = load double, ptr %.1020.1.i, align 8, !noalias !7
  store double %.1022.1.i, ptr %15, align 8, !noalias !7
  %.1022.2.i = load double, ptr %.1020.2.i, align 8, !noalias !7
  store double %.1022.2.i, ptr %gep.2.i, align 8, !noalias !7
  %.621.1.i = load double, ptr %gep1130.1.i, align 8, !noalias !7
  store double %.621.1.i, ptr %sunkaddr24.i, align 8, !noalias !7
  %.766.1.i = load double, ptr %.764.1.i, align 8, !noalias !7
  %.797.1.i = load double, ptr %.344, align 8, !noalias !7
  %.798.1.i = fmul double %.766.1.i, %.797.1.i
  %.799.1.i = fadd double %.621.1.i, %.798.1.i
  store double %.799.1.i, ptr %sunkaddr24.i, align 8, !noalias !7
  %.1022.11190.i = load double, ptr %41, align 8, !noalias !7
  store double %.1022.11190.i, ptr %.1904.1.i, align 8, !noalias !7
  %.1022.1.1.i = load double, ptr %.1020.1.1.i, align 8, !noalias !7
  store double %.1022.1.1.i, ptr %gep.1.1.i, align 8, !noalias !7
  %.1022.2.1.i = load double, ptr %.1020.2.1.i, align 8, !noalias !7
  store double %.1022.2.1.i, ptr %gep.2.1.i, align 8, !noalias !7
  %.621.2.i = load double, ptr %gep1130.2.i, align 8, !noalias !7
  store double %.621.2.i, ptr %sunkaddr26.i, align 8, !noalias !7
  %.766.2.i = load double, ptr %.764.2.i, align 8, !noalias !7
  %.797.2.i = load double, ptr %.344, align 8, !noalias !7
  %.798.2.i = fmul double %.766.2.i, %.797.2.i
  %.799.2.i = fadd double %.621.2.i, %.798.2.i
  br label %B616.endif.2.peel.next.i

B120.us.preheader.i:                              ; preds = %B94
  %.1022.us.i = load double, ptr %arg.X_WO.4, align 8, !noalias !7
  store double %.1022.us.i, ptr %arg.room.4, align 8, !noalias !7
  %.1022.us.1.i = load double, ptr %.1020.1.i, align 8, !noalias !7
  store double %.1022.us.1.i, ptr %15, align 8, !noalias !7
  %.1022.us.2.i = load double, ptr %.1020.2.i, align 8, !noalias !7
  store double %.1022.us.2.i, ptr %gep.2.i, align 8, !noalias !7
  %.621.us.1.i = load double, ptr %gep1130.1.i, align 8, !noalias !7
  store double %.621.us.1.i, ptr %sunkaddr24.i, align 8, !noalias !7
  %.1022.us.11192.i = load double, ptr %41, align 8, !noalias !7
  store double %.1022.us.11192.i, ptr %.1904.1.i, align 8, !noalias !7
  %.1022.us.1.1.i = load double, ptr %.1020.1.1.i, align 8, !noalias !7
  store double %.1022.us.1.1.i, ptr %gep.1.1.i, align 8, !noalias !7
  %.1022.us.2.1.i = load double, ptr %.1020.2.1.i, align 8, !noalias !7
  store double %.1022.us.2.1.i, ptr %gep.2.1.i, align 8, !noalias !7
  %.621.us.2.i = load double, ptr %gep1130.2.i, align 8, !noalias !7
  br label %B616.endif.2.peel.next.i

B616.endif.2.peel.next.i:                         ; preds = %B120.us.preheader.i, %B120.preheader.i
  %storemerge = phi double [ %.799.2.i, %B120.preheader.i ], [ %.621.us.2.i, %B120.us.preheader.i ]
  store double %storemerge, ptr %sunkaddr26.i, align 8, !noalias !7
  %.1022.21191.i = load double, ptr %46, align 8, !noalias !7
  store double %.1022.21191.i, ptr %invariant.gep.2.i, align 8, !noalias !7
  %.1022.1.2.i = load double, ptr %.1020.1.2.i, align 8, !noalias !7
  store double %.1022.1.2.i, ptr %gep.1.2.i, align 8, !noalias !7
  %.1022.2.2.i = load double, ptr %.1020.2.2.i, align 8, !noalias !7
  store double %.1022.2.2.i, ptr %gep.2.2.i, align 8, !noalias !7
  %.1282.peel.i = load double, ptr %.1281.peel.i, align 8, !noalias !7
  %.1314.peel.i = getelementptr i8, ptr %.344, i64 %.1312.peel.i
  %.1316.peel.i = load double, ptr %.1314.peel.i, align 8, !noalias !7
  %.1317.peel.i = fmul double %.1282.peel.i, %.1316.peel.i
  %.1372.peel.i = load double, ptr %.1371.peel.i, align 8, !noalias !7
  %.1373.peel.i = fadd double %.1317.peel.i, %.1372.peel.i
  %.1428.peel.i = load double, ptr %.1427.peel.i, align 8, !noalias !7
  %.1430.peel.i = fmul double %.1428.peel.i, 0.000000e+00
  %.1433.peel.i = fsub double %.1373.peel.i, %.1430.peel.i
  %.1471.peel.i = tail call double @llvm.cos.f64(double %.1433.peel.i)
  %.1472.peel.i = tail call double @llvm.sin.f64(double %.1433.peel.i)
  %.1533.peel.i = load double, ptr %arg.chain.4, align 8, !noalias !7
  %.5.i.peel.i = fptosi double %.1533.peel.i to i64
  %.1562.peel.i = add nsw i64 %.5.i.peel.i, 1
  %.1582.peel.i = srem i64 %.1562.peel.i, 3
  %.1584.peel.i = icmp slt i64 %.1582.peel.i, 0
  %.1593.peel.i = add nsw i64 %.1582.peel.i, 3
  %.1573.1.peel.i = select i1 %.1584.peel.i, i64 %.1593.peel.i, i64 %.1582.peel.i
  %.1604.peel.i = add nsw i64 %.5.i.peel.i, 2
  %.1624.peel.i = srem i64 %.1604.peel.i, 3
  %.1626.peel.i = icmp slt i64 %.1624.peel.i, 0
  %.1635.peel.i = add nsw i64 %.1624.peel.i, 3
  %.1615.1.peel.i = select i1 %.1626.peel.i, i64 %.1635.peel.i, i64 %.1624.peel.i
  %.2265.peel.i = icmp slt i64 %.5.i.peel.i, 0
  %.2266.peel.i = select i1 %.2265.peel.i, i64 %arg.room.5.1, i64 0
  %.2267.peel.i = add i64 %.2266.peel.i, %.5.i.peel.i
  %.2287.peel.i = mul i64 %.2267.peel.i, %arg.room.5.2
  %47 = getelementptr double, ptr %arg.room.4, i64 %.2287.peel.i
  %.1849.peel.i = load double, ptr %.342.i, align 8, !noalias !7
  %.1905.peel.i = load double, ptr %arg.room.4, align 8, !noalias !7
  %.1960.peel.i = load double, ptr %.1959.peel.i, align 8, !noalias !7
  %.1961.peel.i = fmul double %.1905.peel.i, %.1960.peel.i
  %.1962.peel.i = fadd double %.1849.peel.i, %.1961.peel.i
  %.2016.peel.i = load double, ptr %15, align 8, !noalias !7
  %.2071.peel.i = load double, ptr %.2070.peel.i, align 8, !noalias !7
  %.2072.peel.i = fmul double %.2016.peel.i, %.2071.peel.i
  %.2073.peel.i = fadd double %.1962.peel.i, %.2072.peel.i
  %.2127.peel.i = load double, ptr %16, align 8, !noalias !7
  %.2182.peel.i = load double, ptr %.2181.peel.i, align 8, !noalias !7
  %.2183.peel.i = fmul double %.2127.peel.i, %.2182.peel.i
  %.2184.peel.i = fadd double %.2073.peel.i, %.2183.peel.i
  store double %.2184.peel.i, ptr %.342.i, align 8, !noalias !7
  %.2292.peel.i = load double, ptr %47, align 8, !noalias !7
  store double %.2292.peel.i, ptr %sunkaddr55.i, align 8, !noalias !7
  %.1849.1.peel.i = load double, ptr %sunkaddr24.i, align 8, !noalias !7
  %.1905.1.peel.i = load double, ptr %.1904.1.i, align 8, !noalias !7
  %.1960.1.peel.i = load double, ptr %.1959.peel.i, align 8, !noalias !7
  %.1961.1.peel.i = fmul double %.1905.1.peel.i, %.1960.1.peel.i
  %.1962.1.peel.i = fadd double %.1849.1.peel.i, %.1961.1.peel.i
  %.2016.1.peel.i = load double, ptr %.2015.1.i, align 8, !noalias !7
  %.2071.1.peel.i = load double, ptr %.2070.peel.i, align 8, !noalias !7
  %.2072.1.peel.i = fmul double %.2016.1.peel.i, %.2071.1.peel.i
  %.2073.1.peel.i = fadd double %.1962.1.peel.i, %.2072.1.peel.i
  %.2127.1.peel.i = load double, ptr %.2126.1.i, align 8, !noalias !7
  %.2182.1.peel.i = load double, ptr %.2181.peel.i, align 8, !noalias !7
  %.2183.1.peel.i = fmul double %.2127.1.peel.i, %.2182.1.peel.i
  %.2184.1.peel.i = fadd double %.2073.1.peel.i, %.2183.1.peel.i
  store double %.2184.1.peel.i, ptr %sunkaddr24.i, align 8, !noalias !7
  %.2291.1.peel.i = getelementptr i8, ptr %47, i64 8
  %.2292.1.peel.i = load double, ptr %.2291.1.peel.i, align 8, !noalias !7
  store double %.2292.1.peel.i, ptr %sunkaddr60.i, align 8, !noalias !7
  %.1849.2.peel.i = load double, ptr %sunkaddr26.i, align 8, !noalias !7
  %.1905.2.peel.i = load double, ptr %invariant.gep.2.i, align 8, !noalias !7
  %.1960.2.peel.i = load double, ptr %.1959.peel.i, align 8, !noalias !7
  %.1961.2.peel.i = fmul double %.1905.2.peel.i, %.1960.2.peel.i
  %.1962.2.peel.i = fadd double %.1849.2.peel.i, %.1961.2.peel.i
  %.2016.2.peel.i = load double, ptr %.2015.2.i, align 8, !noalias !7
  %.2071.2.peel.i = load double, ptr %.2070.peel.i, align 8, !noalias !7
  %.2072.2.peel.i = fmul double %.2016.2.peel.i, %.2071.2.peel.i
  %.2073.2.peel.i = fadd double %.1962.2.peel.i, %.2072.2.peel.i
  %.2127.2.peel.i = load double, ptr %.2126.2.i, align 8, !noalias !7
  %.2182.2.peel.i = load double, ptr %.2181.peel.i, align 8, !noalias !7
  %.2183.2.peel.i = fmul double %.2127.2.peel.i, %.2182.2.peel.i
  %.2184.2.peel.i = fadd double %.2073.2.peel.i, %.2183.2.peel.i
  store double %.2184.2.peel.i, ptr %sunkaddr26.i, align 8, !noalias !7
  %.2291.2.peel.i = getelementptr i8, ptr %47, i64 16
  %.2292.2.peel.i = load double, ptr %.2291.2.peel.i, align 8, !noalias !7
  store double %.2292.2.peel.i, ptr %sunkaddr65.i, align 8, !noalias !7
  %.2501.peel.i = icmp slt i64 %.1573.1.peel.i, 0
  %.2502.peel.i = select i1 %.2501.peel.i, i64 %arg.room.5.1, i64 0
  %.2503.peel.i = add i64 %.2502.peel.i, %.1573.1.peel.i
  %.2523.peel.i = mul i64 %.2503.peel.i, %arg.room.5.2
  %48 = getelementptr double, ptr %arg.room.4, i64 %.2523.peel.i
  %.2556.peel.i = icmp slt i64 %.1615.1.peel.i, 0
  %.2557.peel.i = select i1 %.2556.peel.i, i64 %arg.room.5.1, i64 0
  %.2558.peel.i = add i64 %.2557.peel.i, %.1615.1.peel.i
  %.2578.peel.i = mul i64 %.2558.peel.i, %arg.room.5.2
  %49 = getelementptr double, ptr %arg.room.4, i64 %.2578.peel.i
  %.2528.peel.i = load double, ptr %48, align 8, !noalias !7
  %.2583.peel.i = load double, ptr %49, align 8, !noalias !7
  %.2587.peel.i = fmul double %.1471.peel.i, %.2528.peel.i
  %.2589.peel.i = fmul double %.1472.peel.i, %.2583.peel.i
  %.2590.peel.i = fadd double %.2587.peel.i, %.2589.peel.i
  %.2592.peel.i = fmul double %.1471.peel.i, %.2583.peel.i
  %.2594.peel.i = fmul double %.1472.peel.i, %.2528.peel.i
  %.2595.peel.i = fsub double %.2592.peel.i, %.2594.peel.i
  store double %.2590.peel.i, ptr %48, align 8, !noalias !7
  store double %.2595.peel.i, ptr %49, align 8, !noalias !7
  %.2527.1.peel.i = getelementptr i8, ptr %48, i64 8
  %.2528.1.peel.i = load double, ptr %.2527.1.peel.i, align 8, !noalias !7
  %.2582.1.peel.i = getelementptr i8, ptr %49, i64 8
  %.2583.1.peel.i = load double, ptr %.2582.1.peel.i, align 8, !noalias !7
  %.2587.1.peel.i = fmul double %.1471.peel.i, %.2528.1.peel.i
  %.2589.1.peel.i = fmul double %.1472.peel.i, %.2583.1.peel.i
  %.2590.1.peel.i = fadd double %.2587.1.peel.i, %.2589.1.peel.i
  %.2592.1.peel.i = fmul double %.1471.peel.i, %.2583.1.peel.i
  %.2594.1.peel.i = fmul double %.1472.peel.i, %.2528.1.peel.i
  %.2595.1.peel.i = fsub double %.2592.1.peel.i, %.2594.1.peel.i
  store double %.2590.1.peel.i, ptr %.2527.1.peel.i, align 8, !noalias !7
  store double %.2595.1.peel.i, ptr %.2582.1.peel.i, align 8, !noalias !7
  %.2527.2.peel.i = getelementptr i8, ptr %48, i64 16
  %.2528.2.peel.i = load double, ptr %.2527.2.peel.i, align 8, !noalias !7
  %.2582.2.peel.i = getelementptr i8, ptr %49, i64 16
  %.2583.2.peel.i = load double, ptr %.2582.2.peel.i, align 8, !noalias !7
  %.2587.2.peel.i = fmul double %.1471.peel.i, %.2528.2.peel.i
  %.2589.2.peel.i = fmul double %.1472.peel.i, %.2583.2.peel.i
  %.2590.2.peel.i = fadd double %.2587.2.peel.i, %.2589.2.peel.i
  %.2592.2.peel.i = fmul double %.1471.peel.i, %.2583.2.peel.i
  %.2594.2.peel.i = fmul double %.1472.peel.i, %.2528.2.peel.i
  %.2595.2.peel.i = fsub double %.2592.2.peel.i, %.2594.2.peel.i
  store double %.2590.2.peel.i, ptr %.2527.2.peel.i, align 8, !noalias !7
  store double %.2595.2.peel.i, ptr %.2582.2.peel.i, align 8, !noalias !7
  br label %B616.endif.2.i

B616.endif.2.i:                                   ; preds = %B616.endif.2.i, %B616.endif.2.peel.next.i
  %lsr.iv37.i = phi i64 [ 5, %B616.endif.2.peel.next.i ], [ %lsr.iv.next38.i, %B616.endif.2.i ]
  %lsr.iv35.i = phi i64 [ %29, %B616.endif.2.peel.next.i ], [ %lsr.iv.next36.i, %B616.endif.2.i ]
  %lsr.iv27.i = phi ptr [ %scevgep26.i, %B616.endif.2.peel.next.i ], [ %scevgep28.i, %B616.endif.2.i ]
  %lsr.iv19.i = phi i64 [ %26, %B616.endif.2.peel.next.i ], [ %lsr.iv.next20.i, %B616.endif.2.i ]
  %lsr.iv12.i = phi i64 [ %22, %B616.endif.2.peel.next.i ], [ %lsr.iv.next13.i, %B616.endif.2.i ]
  %lsr.iv.i = phi i64 [ %17, %B616.endif.2.peel.next.i ], [ %lsr.iv.next.i, %B616.endif.2.i ]
  %before.2.01171.i = phi double [ %.1316.peel.i, %B616.endif.2.peel.next.i ], [ %.1316.i, %B616.endif.2.i ]
  %scevgep32.i = getelementptr i8, ptr %lsr.iv27.i, i64 -48
  %scevgep34.i = getelementptr i8, ptr %lsr.iv27.i, i64 -40
  %.1282.i = load double, ptr %scevgep34.i, align 8, !noalias !7
  %.1299.i = icmp slt i64 %lsr.iv35.i, 0
  %.1300.i = select i1 %.1299.i, i64 %arg.q.5.1, i64 0
  %50 = add i64 %.1300.i, %lsr.iv35.i
  %.1312.i = mul i64 %50, %arg.q.6.1
  %.1314.i = getelementptr i8, ptr %.344, i64 %.1312.i
  %.1316.i = load double, ptr %.1314.i, align 8, !noalias !7
  %.1317.i = fmul double %.1282.i, %.1316.i
  %scevgep33.i = getelementptr i8, ptr %lsr.iv27.i, i64 -32
  %.1372.i = load double, ptr %scevgep33.i, align 8, !noalias !7
  %.1373.i = fadd double %.1317.i, %.1372.i
  %.1428.i = load double, ptr %lsr.iv27.i, align 8, !noalias !7
  %.1430.i = fmul double %before.2.01171.i, %.1428.i
  %.1433.i = fsub double %.1373.i, %.1430.i
  %.1471.i = tail call double @llvm.cos.f64(double %.1433.i)
  %.1472.i = tail call double @llvm.sin.f64(double %.1433.i)
  %.1533.i = load double, ptr %scevgep32.i, align 8, !noalias !7
  %.5.i.i = fptosi double %.1533.i to i64
  %.1562.i = add nsw i64 %.5.i.i, 1
  %.1582.i = srem i64 %.1562.i, 3
  %.1584.i = icmp slt i64 %.1582.i, 0
  %.1593.i = add nsw i64 %.1582.i, 3
  %.1573.1.i = select i1 %.1584.i, i64 %.1593.i, i64 %.1582.i
  %.1604.i = add nsw i64 %.5.i.i, 2
  %.1624.i = srem i64 %.1604.i, 3
  %.1626.i = icmp slt i64 %.1624.i, 0
  %.1635.i = add nsw i64 %.1624.i, 3
  %.1615.1.i = select i1 %.1626.i, i64 %.1635.i, i64 %.1624.i
  %scevgep31.i = getelementptr i8, ptr %lsr.iv27.i, i64 -24
  %scevgep30.i = getelementptr i8, ptr %lsr.iv27.i, i64 -16
  %scevgep29.i = getelementptr i8, ptr %lsr.iv27.i, i64 -8
  %.2265.i = icmp slt i64 %.5.i.i, 0
  %.2266.i = select i1 %.2265.i, i64 %arg.room.5.1, i64 0
  %.2267.i = add i64 %.2266.i, %.5.i.i
  %.2287.i = mul i64 %.2267.i, %arg.room.5.2
  %51 = getelementptr double, ptr %arg.room.4, i64 %.2287.i
  %scevgep10.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv.i
  %scevgep11.i = getelementptr i8, ptr %scevgep10.i, i64 -16
  %.1849.i = load double, ptr %scevgep11.i, align 8, !noalias !7
  %.1905.i = load double, ptr %arg.room.4, align 8, !noalias !7
  %.1960.i = load double, ptr %scevgep31.i, align 8, !noalias !7
  %.1961.i = fmul double %.1905.i, %.1960.i
  %.1962.i = fadd double %.1849.i, %.1961.i
  %.2016.i = load double, ptr %sunkaddr28.i, align 8, !noalias !7
  %.2071.i = load double, ptr %scevgep30.i, align 8, !noalias !7
  %.2072.i = fmul double %.2016.i, %.2071.i
  %.2073.i = fadd double %.1962.i, %.2072.i
  %.2127.i = load double, ptr %16, align 8, !noalias !7
  %.2182.i = load double, ptr %scevgep29.i, align 8, !noalias !7
  %.2183.i = fmul double %.2127.i, %.2182.i
  %.2184.i = fadd double %.2073.i, %.2183.i
  %scevgep14.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv12.i
  %scevgep15.i = getelementptr i8, ptr %scevgep14.i, i64 -16
  store double %.2184.i, ptr %scevgep15.i, align 8, !noalias !7
  %.2292.i = load double, ptr %51, align 8, !noalias !7
  %scevgep21.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv19.i
  %scevgep22.i = getelementptr i8, ptr %scevgep21.i, i64 -16
  store double %.2292.i, ptr %scevgep22.i, align 8, !noalias !7
  %scevgep7.i = getelementptr i8, ptr %scevgep10.i, i64 -8
  %.1849.1.i = load double, ptr %scevgep7.i, align 8, !noalias !7
  %.1905.1.i = load double, ptr %.1904.1.i, align 8, !noalias !7
  %.1960.1.i = load double, ptr %scevgep31.i, align 8, !noalias !7
  %.1961.1.i = fmul double %.1905.1.i, %.1960.1.i
  %.1962.1.i = fadd double %.1849.1.i, %.1961.1.i
  %.2016.1.i = load double, ptr %sunkaddr33.i, align 8, !noalias !7
  %.2071.1.i = load double, ptr %scevgep30.i, align 8, !noalias !7
  %.2072.1.i = fmul double %.2016.1.i, %.2071.1.i
  %.2073.1.i = fadd double %.1962.1.i, %.2072.1.i
  %.2127.1.i = load double, ptr %.2126.1.i, align 8, !noalias !7
  %.2182.1.i = load double, ptr %scevgep29.i, align 8, !noalias !7
  %.2183.1.i = fmul double %.2127.1.i, %.2182.1.i
  %.2184.1.i = fadd double %.2073.1.i, %.2183.1.i
  %scevgep5.i = getelementptr i8, ptr %scevgep14.i, i64 -8
  store double %.2184.1.i, ptr %scevgep5.i, align 8, !noalias !7
  %.2291.1.i = getelementptr i8, ptr %51, i64 8
  %.2292.1.i = load double, ptr %.2291.1.i, align 8, !noalias !7
  %scevgep3.i = getelementptr i8, ptr %scevgep21.i, i64 -8
  store double %.2292.1.i, ptr %scevgep3.i, align 8, !noalias !7
  %.1849.2.i = load double, ptr %scevgep10.i, align 8, !noalias !7
  %.1905.2.i = load double, ptr %invariant.gep.2.i, align 8, !noalias !7
  %.1960.2.i = load double, ptr %scevgep31.i, align 8, !noalias !7
  %.1961.2.i = fmul double %.1905.2.i, %.1960.2.i
  %.1962.2.i = fadd double %.1849.2.i, %.1961.2.i
  %.2016.2.i = load double, ptr %sunkaddr39.i, align 8, !noalias !7
  %.2071.2.i = load double, ptr %scevgep30.i, align 8, !noalias !7
  %.2072.2.i = fmul double %.2016.2.i, %.2071.2.i
  %.2073.2.i = fadd double %.1962.2.i, %.2072.2.i
  %.2127.2.i = load double, ptr %.2126.2.i, align 8, !noalias !7
  %.2182.2.i = load double, ptr %scevgep29.i, align 8, !noalias !7
  %.2183.2.i = fmul double %.2127.2.i, %.2182.2.i
  %.2184.2.i = fadd double %.2073.2.i, %.2183.2.i
  store double %.2184.2.i, ptr %scevgep14.i, align 8, !noalias !7
  %.2291.2.i = getelementptr i8, ptr %51, i64 16
  %.2292.2.i = load double, ptr %.2291.2.i, align 8, !noalias !7
  store double %.2292.2.i, ptr %scevgep21.i, align 8, !noalias !7
  %.2501.i = icmp slt i64 %.1573.1.i, 0
  %.2502.i = select i1 %.2501.i, i64 %arg.room.5.1, i64 0
  %.2503.i = add i64 %.2502.i, %.1573.1.i
  %.2523.i = mul i64 %.2503.i, %arg.room.5.2
  %52 = getelementptr double, ptr %arg.room.4, i64 %.2523.i
  %.2556.i = icmp slt i64 %.1615.1.i, 0
  %.2557.i = select i1 %.2556.i, i64 %arg.room.5.1, i64 0
  %.2558.i = add i64 %.2557.i, %.1615.1.i
  %.2578.i = mul i64 %.2558.i, %arg.room.5.2
  %53 = getelementptr double, ptr %arg.room.4, i64 %.2578.i
  %.2528.i = load double, ptr %52, align 8, !noalias !7
  %.2583.i = load double, ptr %53, align 8, !noalias !7
  %.2587.i = fmul double %.1471.i, %.2528.i
  %.2589.i = fmul double %.1472.i, %.2583.i
  %.2590.i = fadd double %.2587.i, %.2589.i
  %.2592.i = fmul double %.1471.i, %.2583.i
  %.2594.i = fmul double %.1472.i, %.2528.i
  %.2595.i = fsub double %.2592.i, %.2594.i
  store double %.2590.i, ptr %52, align 8, !noalias !7
  store double %.2595.i, ptr %53, align 8, !noalias !7
  %.2527.1.i = getelementptr i8, ptr %52, i64 8
  %.2528.1.i = load double, ptr %.2527.1.i, align 8, !noalias !7
  %.2582.1.i = getelementptr i8, ptr %53, i64 8
  %.2583.1.i = load double, ptr %.2582.1.i, align 8, !noalias !7
  %.2587.1.i = fmul double %.1471.i, %.2528.1.i
  %.2589.1.i = fmul double %.1472.i, %.2583.1.i
  %.2590.1.i = fadd double %.2587.1.i, %.2589.1.i
  %.2592.1.i = fmul double %.1471.i, %.2583.1.i
  %.2594.1.i = fmul double %.1472.i, %.2528.1.i
  %.2595.1.i = fsub double %.2592.1.i, %.2594.1.i
  store double %.2590.1.i, ptr %.2527.1.i, align 8, !noalias !7
  store double %.2595.1.i, ptr %.2582.1.i, align 8, !noalias !7
  %.2527.2.i = getelementptr i8, ptr %52, i64 16
  %.2528.2.i = load double, ptr %.2527.2.i, align 8, !noalias !7
  %.2582.2.i = getelementptr i8, ptr %53, i64 16
  %.2583.2.i = load double, ptr %.2582.2.i, align 8, !noalias !7
  %.2587.2.i = fmul double %.1471.i, %.2528.2.i
  %.2589.2.i = fmul double %.1472.i, %.2583.2.i
  %.2590.2.i = fadd double %.2587.2.i, %.2589.2.i
  %.2592.2.i = fmul double %.1471.i, %.2583.2.i
  %.2594.2.i = fmul double %.1472.i, %.2528.2.i
  %.2595.2.i = fsub double %.2592.2.i, %.2594.2.i
  store double %.2590.2.i, ptr %.2527.2.i, align 8, !noalias !7
  store double %.2595.2.i, ptr %.2582.2.i, align 8, !noalias !7
  %lsr.iv.next.i = add i64 %lsr.iv.i, %18
  %lsr.iv.next13.i = add i64 %lsr.iv12.i, %18
  %lsr.iv.next20.i = add i64 %lsr.iv19.i, %18
  %scevgep28.i = getelementptr i8, ptr %lsr.iv27.i, i64 %27
  %lsr.iv.next36.i = add i64 %lsr.iv35.i, 1
  %lsr.iv.next38.i = add nsw i64 %lsr.iv37.i, -1
  %exitcond.not.i = icmp eq i64 %lsr.iv.next38.i, 0
  br i1 %exitcond.not.i, label %part.0, label %B616.endif.2.i, !llvm.loop !10

part.0: ; preds = %B616.endif.2.i
  %.2922.i = load double, ptr %30, align 8, !noalias !7
  %.2976.i = load double, ptr %arg.room.4, align 8, !noalias !7
  %.3030.i = load double, ptr %.3028.i, align 8, !noalias !7
  %.3031.i = fmul double %.2976.i, %.3030.i
  %.3032.i = fadd double %.2922.i, %.3031.i
  %.3086.i = load double, ptr %sunkaddr28.i, align 8, !noalias !7
  %.3140.i = load double, ptr %.3138.i, align 8, !noalias !7
  %.3141.i = fmul double %.3086.i, %.3140.i
  %.3142.i = fadd double %.3032.i, %.3141.i
  %.3196.i = load double, ptr %16, align 8, !noalias !7
  %.3250.i = load double, ptr %.3248.i, align 8, !noalias !7
  %.3251.i = fmul double %.3196.i, %.3250.i
  %.3252.i = fadd double %.3142.i, %.3251.i
  store double %.3252.i, ptr %33, align 8, !noalias !7
  %.2922.1.i = load double, ptr %.2921.1.i, align 8, !noalias !7
  %.2976.1.i = load double, ptr %.1904.1.i, align 8, !noalias !7
  %.3030.1.i = load double, ptr %.3028.i, align 8, !noalias !7
  %.3031.1.i = fmul double %.2976.1.i, %.3030.1.i
  %.3032.1.i = fadd double %.2922.1.i, %.3031.1.i
  %.3086.1.i = load double, ptr %sunkaddr33.i, align 8, !noalias !7
  %.3140.1.i = load double, ptr %.3138.i, align 8, !noalias !7
  %.3141.1.i = fmul double %.3086.1.i, %.3140.1.i
  %.3142.1.i = fadd double %.3032.1.i, %.3141.1.i
  %.3196.1.i = load double, ptr %.2126.1.i, align 8, !noalias !7
  %.3250.1.i = load double, ptr %.3248.i, align 8, !noalias !7
  %.3251.1.i = fmul double %.3196.1.i, %.3250.1.i
  %.3252.1.i = fadd double %.3142.1.i, %.3251.1.i
  store double %.3252.1.i, ptr %.3305.1.i, align 8, !noalias !7
  %.2922.2.i = load double, ptr %.2921.2.i, align 8, !noalias !7
  %.2976.2.i = load double, ptr %invariant.gep.2.i, align 8, !noalias !7
  %.3030.2.i = load double, ptr %.3028.i, align 8, !noalias !7
  %.3031.2.i = fmul double %.2976.2.i, %.3030.2.i
  %.3032.2.i = fadd double %.2922.2.i, %.3031.2.i
  %.3086.2.i = load double, ptr %sunkaddr39.i, align 8, !noalias !7
  %.3140.2.i = load double, ptr %.3138.i, align 8, !noalias !7
  %.3141.2.i = fmul double %.3086.2.i, %.3140.2.i
  %.3142.2.i = fadd double %.3032.2.i, %.3141.2.i
  %.3196.2.i = load double, ptr %.2126.2.i, align 8, !noalias !7
  %.3250.2.i = load double, ptr %.3248.i, align 8, !noalias !7
  %.3251.2.i = fmul double %.3196.2.i, %.3250.2.i
  %.3252.2.i = fadd double %.3142.2.i, %.3251.2.i
  store double %.3252.2.i, ptr %.3305.2.i, align 8, !noalias !7
  %.482 = mul i64 %.269358371, %.480
  %.484 = getelementptr double, ptr %arg.J.4, i64 %.482
  %scevgep17.i = getelementptr i8, ptr %.484, i64 %36
  %54 = getelementptr i8, ptr %.484, i64 %13
  %scevgep21.i1 = getelementptr i8, ptr %54, i64 %34
  %scevgep25.i = getelementptr i8, ptr %.484, i64 %34
  %55 = getelementptr i8, ptr %.484, i64 %37
  %scevgep29.i2 = getelementptr i8, ptr %55, i64 %34
  %56 = getelementptr i8, ptr %.484, i64 %38
  %scevgep33.i3 = getelementptr i8, ptr %56, i64 %34
  %57 = getelementptr i8, ptr %.484, i64 %39
  %scevgep37.i = getelementptr i8, ptr %57, i64 %34
  br label %switch.end.i

switch.end.1727.i:                                ; preds = %switch.end.1.i, %switch.end.i
  %.1258.1.i = load double, ptr %scevgep2.i, align 8, !noalias !11
  %.1274.1.i = fmul double %.958.i, %.1258.1.i
  %.1383.1.i = load double, ptr %scevgep6.i, align 8, !noalias !11
  %.1386.1.i = fmul double %.1258.1.i, %.1383.1.i
  %scevgep41.i = getelementptr i8, ptr %scevgep17.i, i64 %62
  %scevgep60.i = getelementptr i8, ptr %scevgep41.i, i64 %63
  store double %.1274.1.i, ptr %scevgep60.i, align 8, !noalias !11
  %scevgep49.i = getelementptr i8, ptr %scevgep33.i3, i64 %62
  %scevgep59.i = getelementptr i8, ptr %scevgep49.i, i64 %63
  store double %.1386.1.i, ptr %scevgep59.i, align 8, !noalias !11
  %.1558.1.i = load double, ptr %lsr.iv.i4, align 8, !noalias !11
  %.1560.1.i = fcmp une double %.1558.1.i, 0.000000e+00
  br i1 %.1560.1.i, label %switch.end.1.1.i, label %switch.end.2.i

switch.end.1.1.i:                                 ; preds = %switch.end.1727.i
  %58 = shl i64 %.1595.i, 3
  %scevgep18.i = getelementptr i8, ptr %scevgep17.i, i64 %58
  %scevgep57.i = getelementptr i8, ptr %scevgep18.i, i64 %63
  %scevgep58.i = getelementptr i8, ptr %scevgep57.i, i64 -8
  %.1618.1.i = load double, ptr %scevgep58.i, align 8, !noalias !11
  %.1689.1.i = fmul double %.958.i, %.1558.1.i
  %.1690.1.i = fsub double %.1618.1.i, %.1689.1.i
  store double %.1690.1.i, ptr %scevgep58.i, align 8, !noalias !11
  %scevgep34.i13 = getelementptr i8, ptr %scevgep33.i3, i64 %58
  %scevgep55.i = getelementptr i8, ptr %scevgep34.i13, i64 %63
  %scevgep56.i = getelementptr i8, ptr %scevgep55.i, i64 -8
  %.1798.1.i = load double, ptr %scevgep56.i, align 8, !noalias !11
  %.1853.1.i = load double, ptr %lsr.iv.i4, align 8, !noalias !11
  %.1909.1.i = load double, ptr %scevgep6.i, align 8, !noalias !11
  %.1912.1.i = fmul double %.1853.1.i, %.1909.1.i
  %.1913.1.i = fsub double %.1798.1.i, %.1912.1.i
  store double %.1913.1.i, ptr %scevgep56.i, align 8, !noalias !11
  br label %switch.end.2.i

switch.end.2.i:                                   ; preds = %switch.end.1.1.i, %switch.end.1727.i
  %.1258.2.i = load double, ptr %scevgep2.i, align 8, !noalias !11
  %.1274.2.i = fmul double %.1071.i, %.1258.2.i
  %.1383.2.i = load double, ptr %scevgep3.i6, align 8, !noalias !11
  %.1386.2.i = fmul double %.1258.2.i, %.1383.2.i
  %scevgep43.i = getelementptr i8, ptr %scevgep21.i1, i64 %62
  %scevgep54.i = getelementptr i8, ptr %scevgep43.i, i64 %63
  store double %.1274.2.i, ptr %scevgep54.i, align 8, !noalias !11
  %scevgep47.i = getelementptr i8, ptr %scevgep29.i2, i64 %62
  %scevgep53.i = getelementptr i8, ptr %scevgep47.i, i64 %63
  store double %.1386.2.i, ptr %scevgep53.i, align 8, !noalias !11
  %.1558.2.i = load double, ptr %lsr.iv.i4, align 8, !noalias !11
  %.1560.2.i = fcmp une double %.1558.2.i, 0.000000e+00
  br i1 %.1560.2.i, label %switch.end.1.2.i, label %B702.2.i

switch.end.1.2.i:                                 ; preds = %switch.end.2.i
  %59 = shl i64 %.1595.i, 3
  %scevgep22.i10 = getelementptr i8, ptr %scevgep21.i1, i64 %59
  %scevgep27.i = getelementptr i8, ptr %scevgep22.i10, i64 %63
  %scevgep28.i11 = getelementptr i8, ptr %scevgep27.i, i64 -8
  %.1618.2.i = load double, ptr %scevgep28.i11, align 8, !noalias !11
  %.1689.2.i = fmul double %.1071.i, %.1558.2.i
  %.1690.2.i = fsub double %.1618.2.i, %.1689.2.i
  store double %.1690.2.i, ptr %scevgep28.i11, align 8, !noalias !11
  %scevgep30.i12 = getelementptr i8, ptr %scevgep29.i2, i64 %59
  %scevgep12.i = getelementptr i8, ptr %scevgep30.i12, i64 %63
  %scevgep13.i = getelementptr i8, ptr %scevgep12.i, i64 -8
  %.1798.2.i = load double, ptr %scevgep13.i, align 8, !noalias !11
  %.1853.2.i = load double, ptr %lsr.iv.i4, align 8, !noalias !11
  %.1909.2.i = load double, ptr %scevgep3.i6, align 8, !noalias !11
  %.1912.2.i = fmul double %.1853.2.i, %.1909.2.i
  %.1913.2.i = fsub double %.1798.2.i, %.1912.2.i
  store double %.1913.2.i, ptr %scevgep13.i, align 8, !noalias !11
  br label %B702.2.i

B702.2.i:                                         ; preds = %switch.end.1.2.i, %switch.end.2.i
  %scevgep1.i = getelementptr i8, ptr %lsr.iv.i4, i64 %27
  %lsr.iv.next.i8 = add i64 %lsr.iv3.i, %arg.room.5.2
  %exitcond.not.i9 = icmp eq i64 %.375.i, 6
  br i1 %exitcond.not.i9, label %part.2, label %switch.end.i

switch.end.i:                                     ; preds = %B702.2.i, %part.0
  %lsr.iv3.i = phi i64 [ %lsr.iv.next.i8, %B702.2.i ], [ 2, %part.0 ]
  %lsr.iv.i4 = phi ptr [ %scevgep1.i, %B702.2.i ], [ %.1427.peel.i, %part.0 ]
  %.368714721.i = phi i64 [ %.375.i, %B702.2.i ], [ 0, %part.0 ]
  %.375.i = add nuw nsw i64 %.368714721.i, 1
  %.456.i = load double, ptr %33, align 8, !noalias !11
  %60 = shl i64 %lsr.iv3.i, 3
  %scevgep15.i5 = getelementptr i8, ptr %.342.i, i64 %60
  %scevgep16.i = getelementptr i8, ptr %scevgep15.i5, i64 -16
  %.511.i = load double, ptr %scevgep16.i, align 8, !noalias !11
  %.512.i = fsub double %.456.i, %.511.i
  %.566.i = load double, ptr %.3305.1.i, align 8, !noalias !11
  %scevgep9.i = getelementptr i8, ptr %scevgep15.i5, i64 -8
  %.621.i = load double, ptr %scevgep9.i, align 8, !noalias !11
  %.622.i = fsub double %.566.i, %.621.i
  %.676.i = load double, ptr %.3305.2.i, align 8, !noalias !11
  %.731.i = load double, ptr %scevgep15.i5, align 8, !noalias !11
  %.732.i = fsub double %.676.i, %.731.i
  %scevgep3.i6 = getelementptr i8, ptr %.121.i, i64 %60
  %scevgep6.i = getelementptr i8, ptr %scevgep3.i6, i64 -8
  %.787.i = load double, ptr %scevgep6.i, align 8, !noalias !11
  %.788.i = fmul double %.787.i, %.732.i
  %.843.i = load double, ptr %scevgep3.i6, align 8, !noalias !11
  %.844.i = fmul double %.622.i, %.843.i
  %.845.i = fsub double %.788.i, %.844.i
  %.901.i = fmul double %.512.i, %.843.i
  %scevgep5.i7 = getelementptr i8, ptr %scevgep3.i6, i64 -16
  %.956.i = load double, ptr %scevgep5.i7, align 8, !noalias !11
  %.957.i = fmul double %.732.i, %.956.i
  %.958.i = fsub double %.901.i, %.957.i
  %.1014.i = fmul double %.622.i, %.956.i
  %.1070.i = fmul double %.512.i, %.787.i
  %.1071.i = fsub double %.1014.i, %.1070.i
  %scevgep2.i = getelementptr i8, ptr %lsr.iv.i4, i64 -40
  %61 = add nsw i64 %.368714721.i, %.165
  %.1418.i = icmp slt i64 %61, 0
  %62 = select i1 %.1418.i, i64 %12, i64 0
  %scevgep45.i = getelementptr i8, ptr %scevgep25.i, i64 %62
  %63 = shl nuw nsw i64 %.368714721.i, 3
  %scevgep66.i = getelementptr i8, ptr %scevgep45.i, i64 %63
  %.1594.inv.i = icmp sgt i64 %61, 0
  %.1595.i = select i1 %.1594.inv.i, i64 0, i64 %arg.J.5.2
  %.1258.i = load double, ptr %scevgep2.i, align 8, !noalias !11
  %.1274.i = fmul double %.1258.i, %.845.i
  %.1386.i = fmul double %.956.i, %.1258.i
  store double %.1274.i, ptr %scevgep66.i, align 8, !noalias !11
  %scevgep51.i = getelementptr i8, ptr %scevgep37.i, i64 %62
  %scevgep65.i = getelementptr i8, ptr %scevgep51.i, i64 %63
  store double %.1386.i, ptr %scevgep65.i, align 8, !noalias !11
  %.1558.i = load double, ptr %lsr.iv.i4, align 8, !noalias !11
  %.1560.i = fcmp une double %.1558.i, 0.000000e+00
  br i1 %.1560.i, label %switch.end.1.i, label %switch.end.1727.i

switch.end.1.i:                                   ; preds = %switch.end.i
  %64 = shl i64 %.1595.i, 3
  %scevgep26.i14 = getelementptr i8, ptr %scevgep25.i, i64 %64
  %scevgep63.i = getelementptr i8, ptr %scevgep26.i14, i64 %63
  %scevgep64.i = getelementptr i8, ptr %scevgep63.i, i64 -8
  %.1618.i = load double, ptr %scevgep64.i, align 8, !noalias !11
  %.1689.i = fmul double %.845.i, %.1558.i
  %.1690.i = fsub double %.1618.i, %.1689.i
  store double %.1690.i, ptr %scevgep64.i, align 8, !noalias !11
  %scevgep38.i = getelementptr i8, ptr %scevgep37.i, i64 %64
  %scevgep61.i = getelementptr i8, ptr %scevgep38.i, i64 %63
  %scevgep62.i = getelementptr i8, ptr %scevgep61.i, i64 -8
  %.1798.i = load double, ptr %scevgep62.i, align 8, !noalias !11
  %.1853.i = load double, ptr %lsr.iv.i4, align 8, !noalias !11
  %.1909.i = load double, ptr %scevgep5.i7, align 8, !noalias !11
  %.1912.i = fmul double %.1853.i, %.1909.i
  %.1913.i = fsub double %.1798.i, %.1912.i
  store double %.1913.i, ptr %scevgep62.i, align 8, !noalias !11
  br label %switch.end.1727.i

part.2: ; preds = %B702.2.i
  br i1 %40, label %B234.preheader, label %B92.loopexit

B234:                                             ; preds = %B234.preheader15, %B234
  %lsr.iv32 = phi ptr [ %arg.ride.4, %B234.preheader15 ], [ %scevgep33, %B234 ]
  %lsr.iv30 = phi i64 [ %74, %B234.preheader15 ], [ %lsr.iv.next, %B234 ]
  %lsr.iv27 = phi ptr [ %lsr.iv25, %B234.preheader15 ], [ %scevgep28, %B234 ]
  %scevgep34 = getelementptr i8, ptr %lsr.iv32, i64 %76
  %.717 = load double, ptr %scevgep34, align 8
  %scevgep31 = getelementptr i8, ptr %lsr.iv27, i64 %75
  store double %.717, ptr %scevgep31, align 8
  %scevgep35 = getelementptr i8, ptr %lsr.iv27, i64 %78
  store double 0.000000e+00, ptr %scevgep35, align 8
  %scevgep37 = getelementptr i8, ptr %lsr.iv32, i64 %81
  %.717.1 = load double, ptr %scevgep37, align 8
  %scevgep36 = getelementptr i8, ptr %lsr.iv27, i64 %80
  store double %.717.1, ptr %scevgep36, align 8
  %scevgep29 = getelementptr i8, ptr %lsr.iv27, i64 %73
  store double 0.000000e+00, ptr %scevgep29, align 8
  %scevgep28 = getelementptr i8, ptr %lsr.iv27, i64 %13
  %lsr.iv.next = add i64 %lsr.iv30, -2
  %scevgep33 = getelementptr i8, ptr %lsr.iv32, i64 %14
  %exitcond.not.1 = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not.1, label %B92.loopexit, label %B234, !llvm.loop !14

B292:                                             ; preds = %B92.loopexit, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B234.preheader:                                   ; preds = %part.2
  br i1 %brmerge14, label %B234.preheader13, label %vector.body

vector.body:                                      ; preds = %B234.preheader, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %B234.preheader ]
  %sunkaddr = getelementptr i8, ptr %arg.ride.4, i64 %index
  %65 = load double, ptr %sunkaddr, align 8, !alias.scope !16
  %sunkaddr39 = getelementptr i8, ptr %sunkaddr, i64 1
  %66 = load double, ptr %sunkaddr39, align 8, !alias.scope !16
  %67 = insertelement <2 x double> poison, double %65, i64 0
  %68 = insertelement <2 x double> %67, double %66, i64 1
  %69 = shl i64 %index, 3
  %scevgep19 = getelementptr i8, ptr %lsr.iv, i64 %69
  %scevgep20 = getelementptr i8, ptr %scevgep19, i64 -24
  store <2 x double> %68, ptr %scevgep20, align 8, !alias.scope !19, !noalias !16
  store <2 x double> zeroinitializer, ptr %scevgep19, align 8, !alias.scope !19, !noalias !16
  %index.next = add nuw nsw i64 %index, 2
  %70 = icmp eq i64 %n.vec, %index.next
  br i1 %70, label %middle.block, label %vector.body, !llvm.loop !21

middle.block:                                     ; preds = %vector.body
  br i1 %43, label %B92.loopexit, label %B234.preheader13

B234.preheader13:                                 ; preds = %middle.block, %B234.preheader
  %.655351353.ph = phi i64 [ 0, %B234.preheader ], [ %n.vec, %middle.block ]
  %.neg = or disjoint i64 %.655351353.ph, 1
  br i1 %45, label %B234.prol.loopexit, label %B234.prol

B234.prol:                                        ; preds = %B234.preheader13
  %.713.prol = mul i64 %.655351353.ph, %arg.ride.6.0
  %.715.prol = getelementptr i8, ptr %arg.ride.4, i64 %.713.prol
  %.717.prol = load double, ptr %.715.prol, align 8
  %.788.prol = mul i64 %.655351353.ph, %arg.J.5.2
  %.792.prol = getelementptr double, ptr %.484, i64 %.788.prol
  store double %.717.prol, ptr %.792.prol, align 8
  %.794.prol = add nuw nsw i64 %.655351353.ph, 3
  %.865.prol = mul i64 %.794.prol, %arg.J.5.2
  %.869.prol = getelementptr double, ptr %.484, i64 %.865.prol
  store double 0.000000e+00, ptr %.869.prol, align 8
  br label %B234.prol.loopexit

B234.prol.loopexit:                               ; preds = %B234.prol, %B234.preheader13
  %.655351353.unr = phi i64 [ %.655351353.ph, %B234.preheader13 ], [ %.neg, %B234.prol ]
  %71 = icmp eq i64 %storemerge348, %.neg
  br i1 %71, label %B92.loopexit, label %B234.preheader15

B234.preheader15:                                 ; preds = %B234.prol.loopexit
  %72 = add nuw i64 %.655351353.unr, 4
  %73 = mul i64 %72, %12
  %74 = sub i64 %storemerge348, %.655351353.unr
  %75 = mul i64 %.655351353.unr, %12
  %76 = mul i64 %.655351353.unr, %arg.ride.6.0
  %77 = add nuw i64 %.655351353.unr, 3
  %78 = mul i64 %77, %12
  %79 = add nuw i64 %.655351353.unr, 1
  %80 = mul i64 %79, %12
  %81 = mul i64 %79, %arg.ride.6.0
  br label %B234
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.motions(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.chain.0, ptr readnone captures(none) %arg.chain.1, i64 %arg.chain.2, i64 %arg.chain.3, ptr readonly captures(none) %arg.chain.4, i64 %arg.chain.5.0, i64 %arg.chain.5.1, i64 %arg.chain.6.0, i64 %arg.chain.6.1, ptr readnone captures(none) %arg.X_WO.0, ptr readnone captures(none) %arg.X_WO.1, i64 %arg.X_WO.2, i64 %arg.X_WO.3, ptr readonly captures(none) %arg.X_WO.4, i64 %arg.X_WO.5.0, i64 %arg.X_WO.5.1, i64 %arg.X_WO.6.0, i64 %arg.X_WO.6.1, ptr readnone captures(none) %arg.ride.0, ptr readnone captures(none) %arg.ride.1, i64 %arg.ride.2, i64 %arg.ride.3, ptr readonly captures(none) %arg.ride.4, i64 %arg.ride.5.0, i64 %arg.ride.6.0, ptr readnone captures(none) %arg.X_6T.0, ptr readnone captures(none) %arg.X_6T.1, i64 %arg.X_6T.2, i64 %arg.X_6T.3, ptr readonly captures(none) %arg.X_6T.4, i64 %arg.X_6T.5.0, i64 %arg.X_6T.5.1, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr readnone captures(none) %arg.room.0, ptr readnone captures(none) %arg.room.1, i64 %arg.room.2, i64 %arg.room.3, ptr %arg.room.4, i64 %arg.room.5.0, i64 %arg.room.5.1, i64 %arg.room.5.2, i64 %arg.room.6.0, i64 %arg.room.6.1, i64 %arg.room.6.2, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.6.0, i64 %arg.q.6.1, ptr readnone captures(none) %arg.qd.0, ptr readnone captures(none) %arg.qd.1, i64 %arg.qd.2, i64 %arg.qd.3, ptr readonly captures(none) %arg.qd.4, i64 %arg.qd.5.0, i64 %arg.qd.5.1, i64 %arg.qd.6.0, i64 %arg.qd.6.1, ptr readnone captures(none) %arg.qdd.0, ptr readnone captures(none) %arg.qdd.1, i64 %arg.qdd.2, i64 %arg.qdd.3, ptr readonly captures(none) %arg.qdd.4, i64 %arg.qdd.5.0, i64 %arg.qdd.5.1, i64 %arg.qdd.6.0, i64 %arg.qdd.6.1, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.5.2, i64 %arg.out.6.0, i64 %arg.out.6.1, i64 %arg.out.6.2) local_unnamed_addr #0 {
B0.endif:
  %.284303.not = icmp slt i64 %arg.q.5.0, 1
  br i1 %.284303.not, label %B194, label %B62.lr.ph

B62.lr.ph:                                        ; preds = %B0.endif
  %.638 = shl i64 %arg.out.5.1, 3
  %0 = mul i64 %.638, %arg.out.5.2
  %.162.i = mul i64 %arg.room.5.2, %arg.room.5.1
  %.342.idx.i = shl i64 %.162.i, 4
  %.342.i = getelementptr i8, ptr %arg.room.4, i64 %.342.idx.i
  %.441.i = add nsw i64 %arg.q.5.1, -6
  %.616.i = mul i64 %arg.X_WO.6.1, 3
  %invariant.gep1129.i = getelementptr i8, ptr %arg.X_WO.4, i64 %.616.i
  %.678.not.i = icmp eq i64 %.441.i, 0
  %invariant.gep.2.i = getelementptr i8, ptr %arg.room.4, i64 16
  %gep.1.2.i = getelementptr double, ptr %invariant.gep.2.i, i64 %arg.room.5.2
  %1 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  %.idx1123.i = shl i64 %arg.room.5.2, 4
  %2 = getelementptr i8, ptr %arg.room.4, i64 %.idx1123.i
  %.1904.1.i = getelementptr i8, ptr %arg.room.4, i64 8
  %.2015.1.i = getelementptr i8, ptr %1, i64 8
  %.2126.1.i = getelementptr i8, ptr %2, i64 8
  %.2015.2.i = getelementptr i8, ptr %1, i64 16
  %.2126.2.i = getelementptr i8, ptr %2, i64 16
  %.1281.peel.i = getelementptr i8, ptr %arg.chain.4, i64 8
  %.1299.peel.i = icmp slt i64 %arg.q.5.1, 6
  %.1300.peel.i = select i1 %.1299.peel.i, i64 %arg.q.5.1, i64 0
  %.1301.peel.i = add i64 %.1300.peel.i, %.441.i
  %.1312.peel.i = mul i64 %.1301.peel.i, %arg.q.6.1
  %.1371.peel.i = getelementptr i8, ptr %arg.chain.4, i64 16
  %.1427.peel.i = getelementptr i8, ptr %arg.chain.4, i64 48
  %.1959.peel.i = getelementptr i8, ptr %arg.chain.4, i64 24
  %.2070.peel.i = getelementptr i8, ptr %arg.chain.4, i64 32
  %.2181.peel.i = getelementptr i8, ptr %arg.chain.4, i64 40
  %sunkaddr54.i = shl i64 %.162.i, 3
  %sunkaddr55.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr54.i
  %sunkaddr24.i = getelementptr i8, ptr %.342.i, i64 8
  %sunkaddr60.i = getelementptr i8, ptr %sunkaddr55.i, i64 8
  %sunkaddr26.i = getelementptr i8, ptr %.342.i, i64 16
  %sunkaddr65.i = getelementptr i8, ptr %sunkaddr55.i, i64 16
  %3 = add i64 %.342.idx.i, 16
  %4 = shl i64 %arg.room.5.2, 3
  %5 = shl i64 %arg.room.5.1, 4
  %6 = or disjoint i64 %5, 8
  %7 = mul i64 %6, %arg.room.5.2
  %8 = add i64 %7, 16
  %9 = shl i64 %arg.room.5.1, 3
  %10 = add i64 %9, 8
  %11 = mul i64 %10, %arg.room.5.2
  %12 = add i64 %11, 16
  %13 = shl i64 %arg.chain.5.1, 3
  %14 = getelementptr i8, ptr %arg.chain.4, i64 %13
  %scevgep26.i = getelementptr i8, ptr %14, i64 48
  %15 = add i64 %arg.q.5.1, -5
  %sunkaddr28.i = getelementptr i8, ptr %arg.room.4, i64 %4
  %sunkaddr33.i = getelementptr i8, ptr %sunkaddr28.i, i64 8
  %sunkaddr39.i = getelementptr i8, ptr %sunkaddr28.i, i64 16
  %.idx.i = mul i64 %arg.room.5.2, 40
  %16 = getelementptr i8, ptr %.342.i, i64 %.idx.i
  %.3025.i = mul i64 %arg.X_6T.6.1, 3
  %.3028.i = getelementptr i8, ptr %arg.X_6T.4, i64 %.3025.i
  %17 = getelementptr i8, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0
  %.3138.i = getelementptr i8, ptr %17, i64 %.3025.i
  %.3244.i = shl i64 %arg.X_6T.6.0, 1
  %18 = getelementptr i8, ptr %arg.X_6T.4, i64 %.3244.i
  %.3248.i = getelementptr i8, ptr %18, i64 %.3025.i
  %.idx1122.i = mul i64 %arg.room.5.2, 48
  %19 = getelementptr i8, ptr %.342.i, i64 %.idx1122.i
  %.2921.1.i = getelementptr i8, ptr %16, i64 8
  %.3305.1.i = getelementptr i8, ptr %19, i64 8
  %.2921.2.i = getelementptr i8, ptr %16, i64 16
  %.3305.2.i = getelementptr i8, ptr %19, i64 16
  %.456.not.i = icmp eq i64 %arg.qd.5.1, 6
  %sunkaddr.i = shl i64 %arg.out.5.2, 3
  %arg.out.5.1..i = tail call i64 @llvm.smin.i64(i64 %arg.out.5.2, i64 3)
  %sunkaddr19.i = shl i64 %arg.out.5.1..i, 3
  %.1020.1.i = getelementptr i8, ptr %arg.X_WO.4, i64 %arg.X_WO.6.1
  %.1017.2.i = shl i64 %arg.X_WO.6.1, 1
  %.1020.2.i = getelementptr i8, ptr %arg.X_WO.4, i64 %.1017.2.i
  %.1072.2.i = shl i64 %arg.room.5.2, 1
  %gep.2.i = getelementptr double, ptr %arg.room.4, i64 %.1072.2.i
  %gep1130.1.i = getelementptr i8, ptr %invariant.gep1129.i, i64 %arg.X_WO.6.0
  %.764.1.i = getelementptr i8, ptr %arg.ride.4, i64 %arg.ride.6.0
  %20 = getelementptr i8, ptr %arg.X_WO.4, i64 %arg.X_WO.6.0
  %.1020.1.1.i = getelementptr i8, ptr %20, i64 %arg.X_WO.6.1
  %gep.1.1.i = getelementptr double, ptr %.1904.1.i, i64 %arg.room.5.2
  %.1020.2.1.i = getelementptr i8, ptr %20, i64 %.1017.2.i
  %gep.2.1.i = getelementptr double, ptr %.1904.1.i, i64 %.1072.2.i
  %.615.2.i = shl i64 %arg.X_WO.6.0, 1
  %gep1130.2.i = getelementptr i8, ptr %invariant.gep1129.i, i64 %.615.2.i
  %.762.2.i = shl i64 %arg.ride.6.0, 1
  %.764.2.i = getelementptr i8, ptr %arg.ride.4, i64 %.762.2.i
  %21 = getelementptr i8, ptr %arg.X_WO.4, i64 %.615.2.i
  %.1020.1.2.i = getelementptr i8, ptr %21, i64 %arg.X_WO.6.1
  %.1020.2.2.i = getelementptr i8, ptr %21, i64 %.1017.2.i
  %gep.2.2.i = getelementptr double, ptr %invariant.gep.2.i, i64 %.1072.2.i
  br label %B62

B62:                                              ; preds = %part.3, %B62.lr.ph
  %lsr.iv17 = phi i64 [ %arg.q.5.0, %B62.lr.ph ], [ %lsr.iv.next, %part.3 ]
  %lsr.iv15 = phi ptr [ %arg.q.4, %B62.lr.ph ], [ %scevgep16, %part.3 ]
  %lsr.iv13 = phi ptr [ %arg.qd.4, %B62.lr.ph ], [ %scevgep14, %part.3 ]
  %lsr.iv11 = phi ptr [ %arg.qdd.4, %B62.lr.ph ], [ %scevgep12, %part.3 ]
  %lsr.iv = phi ptr [ %arg.out.4, %B62.lr.ph ], [ %scevgep, %part.3 ]
  %.621.us.i = load double, ptr %invariant.gep1129.i, align 8, !noalias !23
  store double %.621.us.i, ptr %.342.i, align 8, !noalias !23
  br i1 %.678.not.i, label %B120.us.preheader.i, label %B120.preheader.i

B120.preheader.i:                                 ; preds = %B62
  %.766.i = load double, ptr %arg.ride.4, align 8, !noalias !23
  %.797.i = load double, ptr %lsr.iv15, align 8, !noalias !23
  %.798.i = fmul double %.766.i, %.797.i
  %.799.i = fadd double %.621.us.i, %.798.i
  store double %.799.i, ptr %.342.i, align 8, !noalias !23
  %.1022.i = load double, ptr %arg.X_WO.4, align 8, !noalias !23
  store double %.1022.i, ptr %arg.room.4, align 8, !noalias !23
  %.1022.1.i = load double, ptr %.1020.1.i, align 8, !noalias !23
  store double %.1022.1.i, ptr %1, align 8, !noalias !23
  %.1022.2.i = load double, ptr %.1020.2.i, align 8, !noalias !23
  store double %.1022.2.i, ptr %gep.2.i, align 8, !noalias !23
  %.621.1.i = load double, ptr %gep1130.1.i, align 8, !noalias !23
  store double %.621.1.i, ptr %sunkaddr24.i, align 8, !noalias !23
  %.766.1.i = load double, ptr %.764.1.i, align 8, !noalias !23
  %.797.1.i = load double, ptr %lsr.iv15, align 8, !noalias !23
  %.798.1.i = fmul double %.766.1.i, %.797.1.i
  %.799.1.i = fadd double %.621.1.i, %.798.1.i
  store double %.799.1.i, ptr %sunkaddr24.i, align 8, !noalias !23
  %.1022.11190.i = load double, ptr %20, align 8, !noalias !23
  store double %.1022.11190.i, ptr %.1904.1.i, align 8, !noalias !23
  %.1022.1.1.i = load double, ptr %.1020.1.1.i, align 8, !noalias !23
  store double %.1022.1.1.i, ptr %gep.1.1.i, align 8, !noalias !23
  %.1022.2.1.i = load double, ptr %.1020.2.1.i, align 8, !noalias !23
  store double %.1022.2.1.i, ptr %gep.2.1.i, align 8, !noalias !23
  %.621.2.i = load double, ptr %gep1130.2.i, align 8, !noalias !23
  store double %.621.2.i, ptr %sunkaddr26.i, align 8, !noalias !23
  %.766.2.i = load double, ptr %.764.2.i, align 8, !noalias !23
  %.797.2.i = load double, ptr %lsr.iv15, align 8, !noalias !23
  %.798.2.i = fmul double %.766.2.i, %.797.2.i
  %.799.2.i = fadd double %.621.2.i, %.798.2.i
  br label %B616.endif.2.peel.next.i

B120.us.preheader.i:                              ; preds = %B62
  %.1022.us.i = load double, ptr %arg.X_WO.4, align 8, !noalias !23
  store double %.1022.us.i, ptr %arg.room.4, align 8, !noalias !23
  %.1022.us.1.i = load double, ptr %.1020.1.i, align 8, !noalias !23
  store double %.1022.us.1.i, ptr %1, align 8, !noalias !23
  %.1022.us.2.i = load double, ptr %.1020.2.i, align 8, !noalias !23
  store double %.1022.us.2.i, ptr %gep.2.i, align 8, !noalias !23
  %.621.us.1.i = load double, ptr %gep1130.1.i, align 8, !noalias !23
  store double %.621.us.1.i, ptr %sunkaddr24.i, align 8, !noalias !23
  %.1022.us.11192.i = load double, ptr %20, align 8, !noalias !23
  store double %.1022.us.11192.i, ptr %.1904.1.i, align 8, !noalias !23
  %.1022.us.1.1.i = load double, ptr %.1020.1.1.i, align 8, !noalias !23
  store double %.1022.us.1.1.i, ptr %gep.1.1.i, align 8, !noalias !23
  %.1022.us.2.1.i = load double, ptr %.1020.2.1.i, align 8, !noalias !23
  store double %.1022.us.2.1.i, ptr %gep.2.1.i, align 8, !noalias !23
  %.621.us.2.i = load double, ptr %gep1130.2.i, align 8, !noalias !23
  br label %B616.endif.2.peel.next.i

B616.endif.2.peel.next.i:                         ; preds = %B120.us.preheader.i, %B120.preheader.i
  %storemerge = phi double [ %.799.2.i, %B120.preheader.i ], [ %.621.us.2.i, %B120.us.preheader.i ]
  store double %storemerge, ptr %sunkaddr26.i, align 8, !noalias !23
  %.1022.21191.i = load double, ptr %21, align 8, !noalias !23
  store double %.1022.21191.i, ptr %invariant.gep.2.i, align 8, !noalias !23
  %.1022.1.2.i = load double, ptr %.1020.1.2.i, align 8, !noalias !23
  store double %.1022.1.2.i, ptr %gep.1.2.i, align 8, !noalias !23
  %.1022.2.2.i = load double, ptr %.1020.2.2.i, align 8, !noalias !23
  store double %.1022.2.2.i, ptr %gep.2.2.i, align 8, !noalias !23
  %.1282.peel.i = load double, ptr %.1281.peel.i, align 8, !noalias !23
  %.1314.peel.i = getelementptr i8, ptr %lsr.iv15, i64 %.1312.peel.i
  %.1316.peel.i = load double, ptr %.1314.peel.i, align 8, !noalias !23
  %.1317.peel.i = fmul double %.1282.peel.i, %.1316.peel.i
  %.1372.peel.i = load double, ptr %.1371.peel.i, align 8, !noalias !23
  %.1373.peel.i = fadd double %.1317.peel.i, %.1372.peel.i
  %.1428.peel.i = load double, ptr %.1427.peel.i, align 8, !noalias !23
  %.1430.peel.i = fmul double %.1428.peel.i, 0.000000e+00
  %.1433.peel.i = fsub double %.1373.peel.i, %.1430.peel.i
  %.1471.peel.i = tail call double @llvm.cos.f64(double %.1433.peel.i)
  %.1472.peel.i = tail call double @llvm.sin.f64(double %.1433.peel.i)
  %.1533.peel.i = load double, ptr %arg.chain.4, align 8, !noalias !23
  %.5.i.peel.i = fptosi double %.1533.peel.i to i64
  %.1562.peel.i = add nsw i64 %.5.i.peel.i, 1
  %.1582.peel.i = srem i64 %.1562.peel.i, 3
  %.1584.peel.i = icmp slt i64 %.1582.peel.i, 0
  %.1593.peel.i = add nsw i64 %.1582.peel.i, 3
  %.1573.1.peel.i = select i1 %.1584.peel.i, i64 %.1593.peel.i, i64 %.1582.peel.i
  %.1604.peel.i = add nsw i64 %.5.i.peel.i, 2
  %.1624.peel.i = srem i64 %.1604.peel.i, 3
  %.1626.peel.i = icmp slt i64 %.1624.peel.i, 0
  %.1635.peel.i = add nsw i64 %.1624.peel.i, 3
  %.1615.1.peel.i = select i1 %.1626.peel.i, i64 %.1635.peel.i, i64 %.1624.peel.i
  %.2265.peel.i = icmp slt i64 %.5.i.peel.i, 0
  %.2266.peel.i = select i1 %.2265.peel.i, i64 %arg.room.5.1, i64 0
  %.2267.peel.i = add i64 %.2266.peel.i, %.5.i.peel.i
  %.2287.peel.i = mul i64 %.2267.peel.i, %arg.room.5.2
  %22 = getelementptr double, ptr %arg.room.4, i64 %.2287.peel.i
  %.1849.peel.i = load double, ptr %.342.i, align 8, !noalias !23
  %.1905.peel.i = load double, ptr %arg.room.4, align 8, !noalias !23
  %.1960.peel.i = load double, ptr %.1959.peel.i, align 8, !noalias !23
  %.1961.peel.i = fmul double %.1905.peel.i, %.1960.peel.i
  %.1962.peel.i = fadd double %.1849.peel.i, %.1961.peel.i
  %.2016.peel.i = load double, ptr %1, align 8, !noalias !23
  %.2071.peel.i = load double, ptr %.2070.peel.i, align 8, !noalias !23
  %.2072.peel.i = fmul double %.2016.peel.i, %.2071.peel.i
  %.2073.peel.i = fadd double %.1962.peel.i, %.2072.peel.i
  %.2127.peel.i = load double, ptr %2, align 8, !noalias !23
  %.2182.peel.i = load double, ptr %.2181.peel.i, align 8, !noalias !23
  %.2183.peel.i = fmul double %.2127.peel.i, %.2182.peel.i
  %.2184.peel.i = fadd double %.2073.peel.i, %.2183.peel.i
  store double %.2184.peel.i, ptr %.342.i, align 8, !noalias !23
  %.2292.peel.i = load double, ptr %22, align 8, !noalias !23
  store double %.2292.peel.i, ptr %sunkaddr55.i, align 8, !noalias !23
  %.1849.1.peel.i = load double, ptr %sunkaddr24.i, align 8, !noalias !23
  %.1905.1.peel.i = load double, ptr %.1904.1.i, align 8, !noalias !23
  %.1960.1.peel.i = load double, ptr %.1959.peel.i, align 8, !noalias !23
  %.1961.1.peel.i = fmul double %.1905.1.peel.i, %.1960.1.peel.i
  %.1962.1.peel.i = fadd double %.1849.1.peel.i, %.1961.1.peel.i
  %.2016.1.peel.i = load double, ptr %.2015.1.i, align 8, !noalias !23
  %.2071.1.peel.i = load double, ptr %.2070.peel.i, align 8, !noalias !23
  %.2072.1.peel.i = fmul double %.2016.1.peel.i, %.2071.1.peel.i
  %.2073.1.peel.i = fadd double %.1962.1.peel.i, %.2072.1.peel.i
  %.2127.1.peel.i = load double, ptr %.2126.1.i, align 8, !noalias !23
  %.2182.1.peel.i = load double, ptr %.2181.peel.i, align 8, !noalias !23
  %.2183.1.peel.i = fmul double %.2127.1.peel.i, %.2182.1.peel.i
  %.2184.1.peel.i = fadd double %.2073.1.peel.i, %.2183.1.peel.i
  store double %.2184.1.peel.i, ptr %sunkaddr24.i, align 8, !noalias !23
  %.2291.1.peel.i = getelementptr i8, ptr %22, i64 8
  %.2292.1.peel.i = load double, ptr %.2291.1.peel.i, align 8, !noalias !23
  store double %.2292.1.peel.i, ptr %sunkaddr60.i, align 8, !noalias !23
  %.1849.2.peel.i = load double, ptr %sunkaddr26.i, align 8, !noalias !23
  %.1905.2.peel.i = load double, ptr %invariant.gep.2.i, align 8, !noalias !23
  %.1960.2.peel.i = load double, ptr %.1959.peel.i, align 8, !noalias !23
  %.1961.2.peel.i = fmul double %.1905.2.peel.i, %.1960.2.peel.i
  %.1962.2.peel.i = fadd double %.1849.2.peel.i, %.1961.2.peel.i
  %.2016.2.peel.i = load double, ptr %.2015.2.i, align 8, !noalias !23
  %.2071.2.peel.i = load double, ptr %.2070.peel.i, align 8, !noalias !23
  %.2072.2.peel.i = fmul double %.2016.2.peel.i, %.2071.2.peel.i
  %.2073.2.peel.i = fadd double %.1962.2.peel.i, %.2072.2.peel.i
  %.2127.2.peel.i = load double, ptr %.2126.2.i, align 8, !noalias !23
  %.2182.2.peel.i = load double, ptr %.2181.peel.i, align 8, !noalias !23
  %.2183.2.peel.i = fmul double %.2127.2.peel.i, %.2182.2.peel.i
  %.2184.2.peel.i = fadd double %.2073.2.peel.i, %.2183.2.peel.i
  store double %.2184.2.peel.i, ptr %sunkaddr26.i, align 8, !noalias !23
  %.2291.2.peel.i = getelementptr i8, ptr %22, i64 16
  %.2292.2.peel.i = load double, ptr %.2291.2.peel.i, align 8, !noalias !23
  store double %.2292.2.peel.i, ptr %sunkaddr65.i, align 8, !noalias !23
  %.2501.peel.i = icmp slt i64 %.1573.1.peel.i, 0
  %.2502.peel.i = select i1 %.2501.peel.i, i64 %arg.room.5.1, i64 0
  %.2503.peel.i = add i64 %.2502.peel.i, %.1573.1.peel.i
  %.2523.peel.i = mul i64 %.2503.peel.i, %arg.room.5.2
  %23 = getelementptr double, ptr %arg.room.4, i64 %.2523.peel.i
  %.2556.peel.i = icmp slt i64 %.1615.1.peel.i, 0
  %.2557.peel.i = select i1 %.2556.peel.i, i64 %arg.room.5.1, i64 0
  %.2558.peel.i = add i64 %.2557.peel.i, %.1615.1.peel.i
  %.2578.peel.i = mul i64 %.2558.peel.i, %arg.room.5.2
  %24 = getelementptr double, ptr %arg.room.4, i64 %.2578.peel.i
  %.2528.peel.i = load double, ptr %23, align 8, !noalias !23
  %.2583.peel.i = load double, ptr %24, align 8, !noalias !23
  %.2587.peel.i = fmul double %.1471.peel.i, %.2528.peel.i
  %.2589.peel.i = fmul double %.1472.peel.i, %.2583.peel.i
  %.2590.peel.i = fadd double %.2587.peel.i, %.2589.peel.i
  %.2592.peel.i = fmul double %.1471.peel.i, %.2583.peel.i
  %.2594.peel.i = fmul double %.1472.peel.i, %.2528.peel.i
  %.2595.peel.i = fsub double %.2592.peel.i, %.2594.peel.i
  store double %.2590.peel.i, ptr %23, align 8, !noalias !23
  store double %.2595.peel.i, ptr %24, align 8, !noalias !23
  %.2527.1.peel.i = getelementptr i8, ptr %23, i64 8
  %.2528.1.peel.i = load double, ptr %.2527.1.peel.i, align 8, !noalias !23
  %.2582.1.peel.i = getelementptr i8, ptr %24, i64 8
  %.2583.1.peel.i = load double, ptr %.2582.1.peel.i, align 8, !noalias !23
  %.2587.1.peel.i = fmul double %.1471.peel.i, %.2528.1.peel.i
  %.2589.1.peel.i = fmul double %.1472.peel.i, %.2583.1.peel.i
  %.2590.1.peel.i = fadd double %.2587.1.peel.i, %.2589.1.peel.i
  %.2592.1.peel.i = fmul double %.1471.peel.i, %.2583.1.peel.i
  %.2594.1.peel.i = fmul double %.1472.peel.i, %.2528.1.peel.i
  %.2595.1.peel.i = fsub double %.2592.1.peel.i, %.2594.1.peel.i
  store double %.2590.1.peel.i, ptr %.2527.1.peel.i, align 8, !noalias !23
  store double %.2595.1.peel.i, ptr %.2582.1.peel.i, align 8, !noalias !23
  %.2527.2.peel.i = getelementptr i8, ptr %23, i64 16
  %.2528.2.peel.i = load double, ptr %.2527.2.peel.i, align 8, !noalias !23
  %.2582.2.peel.i = getelementptr i8, ptr %24, i64 16
  %.2583.2.peel.i = load double, ptr %.2582.2.peel.i, align 8, !noalias !23
  %.2587.2.peel.i = fmul double %.1471.peel.i, %.2528.2.peel.i
  %.2589.2.peel.i = fmul double %.1472.peel.i, %.2583.2.peel.i
  %.2590.2.peel.i = fadd double %.2587.2.peel.i, %.2589.2.peel.i
  %.2592.2.peel.i = fmul double %.1471.peel.i, %.2583.2.peel.i
  %.2594.2.peel.i = fmul double %.1472.peel.i, %.2528.2.peel.i
  %.2595.2.peel.i = fsub double %.2592.2.peel.i, %.2594.2.peel.i
  store double %.2590.2.peel.i, ptr %.2527.2.peel.i, align 8, !noalias !23
  store double %.2595.2.peel.i, ptr %.2582.2.peel.i, align 8, !noalias !23
  br label %B616.endif.2.i

B616.endif.2.i:                                   ; preds = %B616.endif.2.i, %B616.endif.2.peel.next.i
  %lsr.iv37.i = phi i64 [ 5, %B616.endif.2.peel.next.i ], [ %lsr.iv.next38.i, %B616.endif.2.i ]
  %lsr.iv35.i = phi i64 [ %15, %B616.endif.2.peel.next.i ], [ %lsr.iv.next36.i, %B616.endif.2.i ]
  %lsr.iv27.i = phi ptr [ %scevgep26.i, %B616.endif.2.peel.next.i ], [ %scevgep28.i, %B616.endif.2.i ]
  %lsr.iv19.i = phi i64 [ %12, %B616.endif.2.peel.next.i ], [ %lsr.iv.next20.i, %B616.endif.2.i ]
  %lsr.iv12.i = phi i64 [ %8, %B616.endif.2.peel.next.i ], [ %lsr.iv.next13.i, %B616.endif.2.i ]
  %lsr.iv.i = phi i64 [ %3, %B616.endif.2.peel.next.i ], [ %lsr.iv.next.i, %B616.endif.2.i ]
  %before.2.01171.i = phi double [ %.1316.peel.i, %B616.endif.2.peel.next.i ], [ %.1316.i, %B616.endif.2.i ]
  %scevgep32.i = getelementptr i8, ptr %lsr.iv27.i, i64 -48
  %scevgep34.i = getelementptr i8, ptr %lsr.iv27.i, i64 -40
  %.1282.i = load double, ptr %scevgep34.i, align 8, !noalias !23
  %.1299.i = icmp slt i64 %lsr.iv35.i, 0
  %.1300.i = select i1 %.1299.i, i64 %arg.q.5.1, i64 0
  %25 = add i64 %.1300.i, %lsr.iv35.i
  %.1312.i = mul i64 %25, %arg.q.6.1
  %.1314.i = getelementptr i8, ptr %lsr.iv15, i64 %.1312.i
  %.1316.i = load double, ptr %.1314.i, align 8, !noalias !23
  %.1317.i = fmul double %.1282.i, %.1316.i
  %scevgep33.i = getelementptr i8, ptr %lsr.iv27.i, i64 -32
  %.1372.i = load double, ptr %scevgep33.i, align 8, !noalias !23
  %.1373.i = fadd double %.1317.i, %.1372.i
  %.1428.i = load double, ptr %lsr.iv27.i, align 8, !noalias !23
  %.1430.i = fmul double %before.2.01171.i, %.1428.i
  %.1433.i = fsub double %.1373.i, %.1430.i
  %.1471.i = tail call double @llvm.cos.f64(double %.1433.i)
  %.1472.i = tail call double @llvm.sin.f64(double %.1433.i)
  %.1533.i = load double, ptr %scevgep32.i, align 8, !noalias !23
  %.5.i.i = fptosi double %.1533.i to i64
  %.1562.i = add nsw i64 %.5.i.i, 1
  %.1582.i = srem i64 %.1562.i, 3
  %.1584.i = icmp slt i64 %.1582.i, 0
  %.1593.i = add nsw i64 %.1582.i, 3
  %.1573.1.i = select i1 %.1584.i, i64 %.1593.i, i64 %.1582.i
  %.1604.i = add nsw i64 %.5.i.i, 2
  %.1624.i = srem i64 %.1604.i, 3
  %.1626.i = icmp slt i64 %.1624.i, 0
  %.1635.i = add nsw i64 %.1624.i, 3
  %.1615.1.i = select i1 %.1626.i, i64 %.1635.i, i64 %.1624.i
  %scevgep31.i = getelementptr i8, ptr %lsr.iv27.i, i64 -24
  %scevgep30.i = getelementptr i8, ptr %lsr.iv27.i, i64 -16
  %scevgep29.i = getelementptr i8, ptr %lsr.iv27.i, i64 -8
  %.2265.i = icmp slt i64 %.5.i.i, 0
  %.2266.i = select i1 %.2265.i, i64 %arg.room.5.1, i64 0
  %.2267.i = add i64 %.2266.i, %.5.i.i
  %.2287.i = mul i64 %.2267.i, %arg.room.5.2
  %26 = getelementptr double, ptr %arg.room.4, i64 %.2287.i
  %scevgep10.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv.i
  %scevgep11.i = getelementptr i8, ptr %scevgep10.i, i64 -16
  %.1849.i = load double, ptr %scevgep11.i, align 8, !noalias !23
  %.1905.i = load double, ptr %arg.room.4, align 8, !noalias !23
  %.1960.i = load double, ptr %scevgep31.i, align 8, !noalias !23
  %.1961.i = fmul double %.1905.i, %.1960.i
  %.1962.i = fadd double %.1849.i, %.1961.i
  %.2016.i = load double, ptr %sunkaddr28.i, align 8, !noalias !23
  %.2071.i = load double, ptr %scevgep30.i, align 8, !noalias !23
  %.2072.i = fmul double %.2016.i, %.2071.i
  %.2073.i = fadd double %.1962.i, %.2072.i
  %.2127.i = load double, ptr %2, align 8, !noalias !23
  %.2182.i = load double, ptr %scevgep29.i, align 8, !noalias !23
  %.2183.i = fmul double %.2127.i, %.2182.i
  %.2184.i = fadd double %.2073.i, %.2183.i
  %scevgep14.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv12.i
  %scevgep15.i = getelementptr i8, ptr %scevgep14.i, i64 -16
  store double %.2184.i, ptr %scevgep15.i, align 8, !noalias !23
  %.2292.i = load double, ptr %26, align 8, !noalias !23
  %scevgep21.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv19.i
  %scevgep22.i = getelementptr i8, ptr %scevgep21.i, i64 -16
  store double %.2292.i, ptr %scevgep22.i, align 8, !noalias !23
  %scevgep7.i = getelementptr i8, ptr %scevgep10.i, i64 -8
  %.1849.1.i = load double, ptr %scevgep7.i, align 8, !noalias !23
  %.1905.1.i = load double, ptr %.1904.1.i, align 8, !noalias !23
  %.1960.1.i = load double, ptr %scevgep31.i, align 8, !noalias !23
  %.1961.1.i = fmul double %.1905.1.i, %.1960.1.i
  %.1962.1.i = fadd double %.1849.1.i, %.1961.1.i
  %.2016.1.i = load double, ptr %sunkaddr33.i, align 8, !noalias !23
  %.2071.1.i = load double, ptr %scevgep30.i, align 8, !noalias !23
  %.2072.1.i = fmul double %.2016.1.i, %.2071.1.i
  %.2073.1.i = fadd double %.1962.1.i, %.2072.1.i
  %.2127.1.i = load double, ptr %.2126.1.i, align 8, !noalias !23
  %.2182.1.i = load double, ptr %scevgep29.i, align 8, !noalias !23
  %.2183.1.i = fmul double %.2127.1.i, %.2182.1.i
  %.2184.1.i = fadd double %.2073.1.i, %.2183.1.i
  %scevgep5.i = getelementptr i8, ptr %scevgep14.i, i64 -8
  store double %.2184.1.i, ptr %scevgep5.i, align 8, !noalias !23
  %.2291.1.i = getelementptr i8, ptr %26, i64 8
  %.2292.1.i = load double, ptr %.2291.1.i, align 8, !noalias !23
  %scevgep3.i = getelementptr i8, ptr %scevgep21.i, i64 -8
  store double %.2292.1.i, ptr %scevgep3.i, align 8, !noalias !23
  %.1849.2.i = load double, ptr %scevgep10.i, align 8, !noalias !23
  %.1905.2.i = load double, ptr %invariant.gep.2.i, align 8, !noalias !23
  %.1960.2.i = load double, ptr %scevgep31.i, align 8, !noalias !23
  %.1961.2.i = fmul double %.1905.2.i, %.1960.2.i
  %.1962.2.i = fadd double %.1849.2.i, %.1961.2.i
  %.2016.2.i = load double, ptr %sunkaddr39.i, align 8, !noalias !23
  %.2071.2.i = load double, ptr %scevgep30.i, align 8, !noalias !23
  %.2072.2.i = fmul double %.2016.2.i, %.2071.2.i
  %.2073.2.i = fadd double %.1962.2.i, %.2072.2.i
  %.2127.2.i = load double, ptr %.2126.2.i, align 8, !noalias !23
  %.2182.2.i = load double, ptr %scevgep29.i, align 8, !noalias !23
  %.2183.2.i = fmul double %.2127.2.i, %.2182.2.i
  %.2184.2.i = fadd double %.2073.2.i, %.2183.2.i
  store double %.2184.2.i, ptr %scevgep14.i, align 8, !noalias !23
  %.2291.2.i = getelementptr i8, ptr %26, i64 16
  %.2292.2.i = load double, ptr %.2291.2.i, align 8, !noalias !23
  store double %.2292.2.i, ptr %scevgep21.i, align 8, !noalias !23
  %.2501.i = icmp slt i64 %.1573.1.i, 0
  %.2502.i = select i1 %.2501.i, i64 %arg.room.5.1, i64 0
  %.2503.i = add i64 %.2502.i, %.1573.1.i
  %.2523.i = mul i64 %.2503.i, %arg.room.5.2
  %27 = getelementptr double, ptr %arg.room.4, i64 %.2523.i
  %.2556.i = icmp slt i64 %.1615.1.i, 0
  %.2557.i = select i1 %.2556.i, i64 %arg.room.5.1, i64 0
  %.2558.i = add i64 %.2557.i, %.1615.1.i
  %.2578.i = mul i64 %.2558.i, %arg.room.5.2
  %28 = getelementptr double, ptr %arg.room.4, i64 %.2578.i
  %.2528.i = load double, ptr %27, align 8, !noalias !23
  %.2583.i = load double, ptr %28, align 8, !noalias !23
  %.2587.i = fmul double %.1471.i, %.2528.i
  %.2589.i = fmul double %.1472.i, %.2583.i
  %.2590.i = fadd double %.2587.i, %.2589.i
  %.2592.i = fmul double %.1471.i, %.2583.i
  %.2594.i = fmul double %.1472.i, %.2528.i
  %.2595.i = fsub double %.2592.i, %.2594.i
  store double %.2590.i, ptr %27, align 8, !noalias !23
  store double %.2595.i, ptr %28, align 8, !noalias !23
  %.2527.1.i = getelementptr i8, ptr %27, i64 8
  %.2528.1.i = load double, ptr %.2527.1.i, align 8, !noalias !23
  %.2582.1.i = getelementptr i8, ptr %28, i64 8
  %.2583.1.i = load double, ptr %.2582.1.i, align 8, !noalias !23
  %.2587.1.i = fmul double %.1471.i, %.2528.1.i
  %.2589.1.i = fmul double %.1472.i, %.2583.1.i
  %.2590.1.i = fadd double %.2587.1.i, %.2589.1.i
  %.2592.1.i = fmul double %.1471.i, %.2583.1.i
  %.2594.1.i = fmul double %.1472.i, %.2528.1.i
  %.2595.1.i = fsub double %.2592.1.i, %.2594.1.i
  store double %.2590.1.i, ptr %.2527.1.i, align 8, !noalias !23
  store double %.2595.1.i, ptr %.2582.1.i, align 8, !noalias !23
  %.2527.2.i = getelementptr i8, ptr %27, i64 16
  %.2528.2.i = load double, ptr %.2527.2.i, align 8, !noalias !23
  %.2582.2.i = getelementptr i8, ptr %28, i64 16
  %.2583.2.i = load double, ptr %.2582.2.i, align 8, !noalias !23
  %.2587.2.i = fmul double %.1471.i, %.2528.2.i
  %.2589.2.i = fmul double %.1472.i, %.2583.2.i
  %.2590.2.i = fadd double %.2587.2.i, %.2589.2.i
  %.2592.2.i = fmul double %.1471.i, %.2583.2.i
  %.2594.2.i = fmul double %.1472.i, %.2528.2.i
  %.2595.2.i = fsub double %.2592.2.i, %.2594.2.i
  store double %.2590.2.i, ptr %.2527.2.i, align 8, !noalias !23
  store double %.2595.2.i, ptr %.2582.2.i, align 8, !noalias !23
  %lsr.iv.next.i = add i64 %lsr.iv.i, %4
  %lsr.iv.next13.i = add i64 %lsr.iv12.i, %4
  %lsr.iv.next20.i = add i64 %lsr.iv19.i, %4
  %scevgep28.i = getelementptr i8, ptr %lsr.iv27.i, i64 %13
  %lsr.iv.next36.i = add i64 %lsr.iv35.i, 1
  %lsr.iv.next38.i = add nsw i64 %lsr.iv37.i, -1
  %exitcond.not.i = icmp eq i64 %lsr.iv.next38.i, 0
  br i1 %exitcond.not.i, label %part.0, label %B616.endif.2.i, !llvm.loop !26

part.0: ; preds = %B616.endif.2.i
  %.2922.i = load double, ptr %16, align 8, !noalias !23
  %.2976.i = load double, ptr %arg.room.4, align 8, !noalias !23
  %.3030.i = load double, ptr %.3028.i, align 8, !noalias !23
  %.3031.i = fmul double %.2976.i, %.3030.i
  %.3032.i = fadd double %.2922.i, %.3031.i
  %.3086.i = load double, ptr %sunkaddr28.i, align 8, !noalias !23
  %.3140.i = load double, ptr %.3138.i, align 8, !noalias !23
  %.3141.i = fmul double %.3086.i, %.3140.i
  %.3142.i = fadd double %.3032.i, %.3141.i
  %.3196.i = load double, ptr %2, align 8, !noalias !23
  %.3250.i = load double, ptr %.3248.i, align 8, !noalias !23
  %.3251.i = fmul double %.3196.i, %.3250.i
  %.3252.i = fadd double %.3142.i, %.3251.i
  store double %.3252.i, ptr %19, align 8, !noalias !23
  %.2922.1.i = load double, ptr %.2921.1.i, align 8, !noalias !23
  %.2976.1.i = load double, ptr %.1904.1.i, align 8, !noalias !23
  %.3030.1.i = load double, ptr %.3028.i, align 8, !noalias !23
  %.3031.1.i = fmul double %.2976.1.i, %.3030.1.i
  %.3032.1.i = fadd double %.2922.1.i, %.3031.1.i
  %.3086.1.i = load double, ptr %sunkaddr33.i, align 8, !noalias !23
  %.3140.1.i = load double, ptr %.3138.i, align 8, !noalias !23
  %.3141.1.i = fmul double %.3086.1.i, %.3140.1.i
  %.3142.1.i = fadd double %.3032.1.i, %.3141.1.i
  %.3196.1.i = load double, ptr %.2126.1.i, align 8, !noalias !23
  %.3250.1.i = load double, ptr %.3248.i, align 8, !noalias !23
  %.3251.1.i = fmul double %.3196.1.i, %.3250.1.i
  %.3252.1.i = fadd double %.3142.1.i, %.3251.1.i
  store double %.3252.1.i, ptr %.3305.1.i, align 8, !noalias !23
  %.2922.2.i = load double, ptr %.2921.2.i, align 8, !noalias !23
  %.2976.2.i = load double, ptr %invariant.gep.2.i, align 8, !noalias !23
  %.3030.2.i = load double, ptr %.3028.i, align 8, !noalias !23
  %.3031.2.i = fmul double %.2976.2.i, %.3030.2.i
  %.3032.2.i = fadd double %.2922.2.i, %.3031.2.i
  %.3086.2.i = load double, ptr %sunkaddr39.i, align 8, !noalias !23
  %.3140.2.i = load double, ptr %.3138.i, align 8, !noalias !23
  %.3141.2.i = fmul double %.3086.2.i, %.3140.2.i
  %.3142.2.i = fadd double %.3032.2.i, %.3141.2.i
  %.3196.2.i = load double, ptr %.2126.2.i, align 8, !noalias !23
  %.3250.2.i = load double, ptr %.3248.i, align 8, !noalias !23
  %.3251.2.i = fmul double %.3196.2.i, %.3250.2.i
  %.3252.2.i = fadd double %.3142.2.i, %.3251.2.i
  store double %.3252.2.i, ptr %.3305.2.i, align 8, !noalias !23
  %29 = getelementptr double, ptr %lsr.iv, i64 %arg.out.5.2
  br i1 %.456.not.i, label %B104.us.preheader.i, label %B104.preheader.i

B104.preheader.i:                                 ; preds = %part.0
  %.489.i = load double, ptr %arg.ride.4, align 8, !noalias !27
  %.520.i = load double, ptr %lsr.iv13, align 8, !noalias !27
  %.521.i = fmul double %.489.i, %.520.i
  store double %.521.i, ptr %lsr.iv, align 8, !noalias !27
  %.621.i = load double, ptr %arg.ride.4, align 8, !noalias !27
  %.652.i = load double, ptr %lsr.iv11, align 8, !noalias !27
  %.653.i = fmul double %.621.i, %.652.i
  store double %.653.i, ptr %29, align 8, !noalias !27
  %.773.i = getelementptr i8, ptr %lsr.iv, i64 24
  store double 0.000000e+00, ptr %.773.i, align 8, !noalias !27
  %.831.i = getelementptr i8, ptr %29, i64 24
  store double 0.000000e+00, ptr %.831.i, align 8, !noalias !27
  %.489.1.i = load double, ptr %.764.1.i, align 8, !noalias !27
  %.520.1.i = load double, ptr %lsr.iv13, align 8, !noalias !27
  %.521.1.i = fmul double %.489.1.i, %.520.1.i
  %.583.1.i = getelementptr i8, ptr %lsr.iv, i64 8
  store double %.521.1.i, ptr %.583.1.i, align 8, !noalias !27
  %.621.1.i1 = load double, ptr %.764.1.i, align 8, !noalias !27
  %.652.1.i = load double, ptr %lsr.iv11, align 8, !noalias !27
  %.653.1.i = fmul double %.621.1.i1, %.652.1.i
  %.715.1.i = getelementptr i8, ptr %29, i64 8
  store double %.653.1.i, ptr %.715.1.i, align 8, !noalias !27
  %.773.1.i = getelementptr i8, ptr %lsr.iv, i64 32
  store double 0.000000e+00, ptr %.773.1.i, align 8, !noalias !27
  %.831.1.i = getelementptr i8, ptr %29, i64 32
  store double 0.000000e+00, ptr %.831.1.i, align 8, !noalias !27
  %.489.2.i = load double, ptr %.764.2.i, align 8, !noalias !27
  %.520.2.i = load double, ptr %lsr.iv13, align 8, !noalias !27
  %.521.2.i = fmul double %.489.2.i, %.520.2.i
  %.583.2.i = getelementptr i8, ptr %lsr.iv, i64 16
  store double %.521.2.i, ptr %.583.2.i, align 8, !noalias !27
  %.621.2.i2 = load double, ptr %.764.2.i, align 8, !noalias !27
  %.652.2.i = load double, ptr %lsr.iv11, align 8, !noalias !27
  %.653.2.i = fmul double %.621.2.i2, %.652.2.i
  br label %B252.else.endif.i

B104.us.preheader.i:                              ; preds = %part.0
  store double 0.000000e+00, ptr %lsr.iv, align 8, !noalias !27
  store double 0.000000e+00, ptr %29, align 8, !noalias !27
  %.773.us.i = getelementptr i8, ptr %lsr.iv, i64 24
  store double 0.000000e+00, ptr %.773.us.i, align 8, !noalias !27
  %.831.us.i = getelementptr i8, ptr %29, i64 24
  store double 0.000000e+00, ptr %.831.us.i, align 8, !noalias !27
  %.583.us.1.i = getelementptr i8, ptr %lsr.iv, i64 8
  store double 0.000000e+00, ptr %.583.us.1.i, align 8, !noalias !27
  %.715.us.1.i = getelementptr i8, ptr %29, i64 8
  store double 0.000000e+00, ptr %.715.us.1.i, align 8, !noalias !27
  %.773.us.1.i = getelementptr i8, ptr %lsr.iv, i64 32
  store double 0.000000e+00, ptr %.773.us.1.i, align 8, !noalias !27
  %.831.us.1.i = getelementptr i8, ptr %29, i64 32
  store double 0.000000e+00, ptr %.831.us.1.i, align 8, !noalias !27
  %.583.us.2.i = getelementptr i8, ptr %lsr.iv, i64 16
  store double 0.000000e+00, ptr %.583.us.2.i, align 8, !noalias !27
  br label %B252.else.endif.i

B252.else.endif.i:                                ; preds = %B104.us.preheader.i, %B104.preheader.i
  %.653.2.sink.i = phi double [ %.653.2.i, %B104.preheader.i ], [ 0.000000e+00, %B104.us.preheader.i ]
  %sunkaddr22.i = getelementptr i8, ptr %lsr.iv, i64 %sunkaddr.i
  %sunkaddr23.i = getelementptr i8, ptr %sunkaddr22.i, i64 16
  store double %.653.2.sink.i, ptr %sunkaddr23.i, align 8, !noalias !27
  %.773.2.i = getelementptr i8, ptr %lsr.iv, i64 40
  store double 0.000000e+00, ptr %.773.2.i, align 8, !noalias !27
  %sunkaddr26.i3 = getelementptr i8, ptr %sunkaddr22.i, i64 40
  store double 0.000000e+00, ptr %sunkaddr26.i3, align 8, !noalias !27
  %sunkaddr20.i = getelementptr i8, ptr %29, i64 %sunkaddr19.i
  %sunkaddr24.i4 = getelementptr i8, ptr %lsr.iv, i64 %sunkaddr19.i
  %sunkaddr25.i = getelementptr i8, ptr %sunkaddr24.i4, i64 8
  %sunkaddr29.i = getelementptr i8, ptr %sunkaddr24.i4, i64 16
  %sunkaddr32.i = getelementptr i8, ptr %sunkaddr20.i, i64 8
  %sunkaddr41.i = getelementptr i8, ptr %sunkaddr20.i, i64 16
  %sunkaddr43.i = getelementptr i8, ptr %29, i64 8
  %sunkaddr44.i = getelementptr i8, ptr %29, i64 16
  %sunkaddr45.i = getelementptr i8, ptr %lsr.iv, i64 8
  %sunkaddr46.i = getelementptr i8, ptr %lsr.iv, i64 16
  br label %switch.end.2.i

switch.end.2.i:                                   ; preds = %switch.end.2.i, %B252.else.endif.i
  %lsr.iv1.i = phi i64 [ %lsr.iv.next.i20, %switch.end.2.i ], [ -6, %B252.else.endif.i ]
  %lsr.iv13.i = phi ptr [ %scevgep14.i19, %switch.end.2.i ], [ %.1427.peel.i, %B252.else.endif.i ]
  %lsr.iv.i5 = phi ptr [ %scevgep1.i, %switch.end.2.i ], [ %invariant.gep.2.i, %B252.else.endif.i ]
  %before_2.2.01439.i = phi double [ %.1620.i, %switch.end.2.i ], [ 0.000000e+00, %B252.else.endif.i ]
  %before.2.01438.i = phi double [ %.1473.i, %switch.end.2.i ], [ 0.000000e+00, %B252.else.endif.i ]
  %scevgep15.i6 = getelementptr i8, ptr %lsr.iv13.i, i64 -40
  %.1440.i = load double, ptr %scevgep15.i6, align 8, !noalias !27
  %30 = add i64 %lsr.iv1.i, %arg.qd.5.1
  %.1456.i = icmp slt i64 %30, 0
  %.1457.i = select i1 %.1456.i, i64 %arg.qd.5.1, i64 0
  %31 = add i64 %.1457.i, %30
  %.1469.i = mul i64 %31, %arg.qd.6.1
  %.1471.i7 = getelementptr i8, ptr %lsr.iv13, i64 %.1469.i
  %.1473.i = load double, ptr %.1471.i7, align 8, !noalias !27
  %.1474.i = fmul double %.1440.i, %.1473.i
  %.1528.i = load double, ptr %lsr.iv13.i, align 8, !noalias !27
  %.1530.i = fmul double %before.2.01438.i, %.1528.i
  %.1533.i8 = fsub double %.1474.i, %.1530.i
  %.1604.i9 = select i1 %.1456.i, i64 %arg.qdd.5.1, i64 0
  %32 = add i64 %.1604.i9, %30
  %.1616.i = mul i64 %32, %arg.qdd.6.1
  %.1618.i = getelementptr i8, ptr %lsr.iv11, i64 %.1616.i
  %.1620.i = load double, ptr %.1618.i, align 8, !noalias !27
  %.1621.i = fmul double %.1440.i, %.1620.i
  %.1677.i = fmul double %before_2.2.01439.i, %.1528.i
  %.1680.i = fsub double %.1621.i, %.1677.i
  %sunkaddr12.i = getelementptr i8, ptr %lsr.iv.i5, i64 %sunkaddr54.i
  %sunkaddr13.i = getelementptr i8, ptr %sunkaddr12.i, i64 -16
  %.1806.i = load double, ptr %sunkaddr13.i, align 8, !noalias !27
  %sunkaddr16.i = getelementptr i8, ptr %sunkaddr12.i, i64 -8
  %.1860.i = load double, ptr %sunkaddr16.i, align 8, !noalias !27
  %.1914.i = load double, ptr %sunkaddr12.i, align 8, !noalias !27
  %.1944.i = load double, ptr %sunkaddr20.i, align 8, !noalias !27
  %.1945.i = fmul double %.1806.i, %.1680.i
  %.1975.i = load double, ptr %sunkaddr25.i, align 8, !noalias !27
  %.1976.i = fmul double %.1914.i, %.1975.i
  %.2006.i = load double, ptr %sunkaddr29.i, align 8, !noalias !27
  %.2007.i = fmul double %.1860.i, %.2006.i
  %.2008.i = fsub double %.1976.i, %.2007.i
  %.2009.i = fmul double %.1533.i8, %.2008.i
  %.2010.i = fadd double %.1945.i, %.2009.i
  %.2011.i = fadd double %.1944.i, %.2010.i
  store double %.2011.i, ptr %sunkaddr20.i, align 8, !noalias !27
  %.2071.i10 = load double, ptr %sunkaddr32.i, align 8, !noalias !27
  %.2072.i11 = fmul double %.1680.i, %.1860.i
  %.2102.i = load double, ptr %sunkaddr29.i, align 8, !noalias !27
  %.2103.i = fmul double %.1806.i, %.2102.i
  %.2133.i = load double, ptr %sunkaddr24.i4, align 8, !noalias !27
  %.2134.i = fmul double %.1914.i, %.2133.i
  %.2135.i = fsub double %.2103.i, %.2134.i
  %.2136.i = fmul double %.1533.i8, %.2135.i
  %.2137.i = fadd double %.2072.i11, %.2136.i
  %.2138.i = fadd double %.2071.i10, %.2137.i
  store double %.2138.i, ptr %sunkaddr32.i, align 8, !noalias !27
  %.2198.i = load double, ptr %sunkaddr41.i, align 8, !noalias !27
  %.2199.i = fmul double %.1680.i, %.1914.i
  %.2229.i = load double, ptr %sunkaddr24.i4, align 8, !noalias !27
  %.2230.i = fmul double %.1860.i, %.2229.i
  %.2260.i = load double, ptr %sunkaddr25.i, align 8, !noalias !27
  %.2261.i = fmul double %.1806.i, %.2260.i
  %.2262.i = fsub double %.2230.i, %.2261.i
  %.2263.i = fmul double %.1533.i8, %.2262.i
  %.2264.i = fadd double %.2199.i, %.2263.i
  %.2265.i12 = fadd double %.2198.i, %.2264.i
  store double %.2265.i12, ptr %sunkaddr41.i, align 8, !noalias !27
  %.2325.i = load double, ptr %sunkaddr24.i4, align 8, !noalias !27
  %.2326.i = fmul double %.1533.i8, %.1806.i
  %.2327.i = fadd double %.2326.i, %.2325.i
  store double %.2327.i, ptr %sunkaddr24.i4, align 8, !noalias !27
  %.2387.i = load double, ptr %sunkaddr25.i, align 8, !noalias !27
  %.2388.i = fmul double %.1533.i8, %.1860.i
  %.2389.i = fadd double %.2388.i, %.2387.i
  store double %.2389.i, ptr %sunkaddr25.i, align 8, !noalias !27
  %.2449.i = load double, ptr %sunkaddr29.i, align 8, !noalias !27
  %.2450.i = fmul double %.1533.i8, %.1914.i
  %.2451.i = fadd double %.2450.i, %.2449.i
  store double %.2451.i, ptr %sunkaddr29.i, align 8, !noalias !27
  %scevgep7.i13 = getelementptr i8, ptr %lsr.iv.i5, i64 %7
  %scevgep10.i14 = getelementptr i8, ptr %scevgep7.i13, i64 -16
  %.2536.i = load double, ptr %scevgep10.i14, align 8, !noalias !27
  %scevgep2.i = getelementptr i8, ptr %lsr.iv.i5, i64 %.342.idx.i
  %scevgep3.i15 = getelementptr i8, ptr %scevgep2.i, i64 -16
  %.2590.i16 = load double, ptr %scevgep3.i15, align 8, !noalias !27
  %.2591.i = fsub double %.2536.i, %.2590.i16
  %scevgep9.i = getelementptr i8, ptr %scevgep7.i13, i64 -8
  %.2646.i = load double, ptr %scevgep9.i, align 8, !noalias !27
  %scevgep5.i17 = getelementptr i8, ptr %scevgep2.i, i64 -8
  %.2700.i = load double, ptr %scevgep5.i17, align 8, !noalias !27
  %.2701.i = fsub double %.2646.i, %.2700.i
  %.2756.i = load double, ptr %scevgep7.i13, align 8, !noalias !27
  %.2810.i = load double, ptr %scevgep2.i, align 8, !noalias !27
  %.2811.i = fsub double %.2756.i, %.2810.i
  %.2842.i = fmul double %.2389.i, %.2811.i
  %.2873.i = fmul double %.2451.i, %.2701.i
  %.2874.i = fsub double %.2842.i, %.2873.i
  %.2905.i = fmul double %.2451.i, %.2591.i
  %.2936.i = fmul double %.2327.i, %.2811.i
  %.2937.i = fsub double %.2905.i, %.2936.i
  %.2968.i = fmul double %.2327.i, %.2701.i
  %.2999.i = fmul double %.2389.i, %.2591.i
  %.3000.i = fsub double %.2968.i, %.2999.i
  %.3066.i = load double, ptr %29, align 8, !noalias !27
  %.3096.i = load double, ptr %sunkaddr32.i, align 8, !noalias !27
  %.3097.i = fmul double %.2811.i, %.3096.i
  %.3127.i = load double, ptr %sunkaddr41.i, align 8, !noalias !27
  %.3128.i = fmul double %.2701.i, %.3127.i
  %.3129.i = fsub double %.3097.i, %.3128.i
  %.3162.i = fmul double %.2389.i, %.3000.i
  %.3163.i = fadd double %.3162.i, %.3129.i
  %.3196.i18 = fmul double %.2451.i, %.2937.i
  %.3197.i = fsub double %.3163.i, %.3196.i18
  %.3198.i = fadd double %.3066.i, %.3197.i
  store double %.3198.i, ptr %29, align 8, !noalias !27
  %.3306.i = load double, ptr %sunkaddr43.i, align 8, !noalias !27
  %.3336.i = load double, ptr %sunkaddr41.i, align 8, !noalias !27
  %.3337.i = fmul double %.2591.i, %.3336.i
  %.3367.i = load double, ptr %sunkaddr20.i, align 8, !noalias !27
  %.3368.i = fmul double %.2811.i, %.3367.i
  %.3369.i = fsub double %.3337.i, %.3368.i
  %.3399.i = load double, ptr %sunkaddr29.i, align 8, !noalias !27
  %.3402.i = fmul double %.2874.i, %.3399.i
  %.3403.i = fadd double %.3369.i, %.3402.i
  %.3433.i = load double, ptr %sunkaddr24.i4, align 8, !noalias !27
  %.3436.i = fmul double %.3000.i, %.3433.i
  %.3437.i = fsub double %.3403.i, %.3436.i
  %.3438.i = fadd double %.3306.i, %.3437.i
  store double %.3438.i, ptr %sunkaddr43.i, align 8, !noalias !27
  %.3546.i = load double, ptr %sunkaddr44.i, align 8, !noalias !27
  %.3576.i = load double, ptr %sunkaddr20.i, align 8, !noalias !27
  %.3577.i = fmul double %.2701.i, %.3576.i
  %.3607.i = load double, ptr %sunkaddr32.i, align 8, !noalias !27
  %.3608.i = fmul double %.2591.i, %.3607.i
  %.3609.i = fsub double %.3577.i, %.3608.i
  %.3639.i = load double, ptr %sunkaddr24.i4, align 8, !noalias !27
  %.3642.i = fmul double %.2937.i, %.3639.i
  %.3643.i = fadd double %.3609.i, %.3642.i
  %.3673.i = load double, ptr %sunkaddr25.i, align 8, !noalias !27
  %.3676.i = fmul double %.2874.i, %.3673.i
  %.3677.i = fsub double %.3643.i, %.3676.i
  %.3678.i = fadd double %.3546.i, %.3677.i
  store double %.3678.i, ptr %sunkaddr44.i, align 8, !noalias !27
  %.3901.i = load double, ptr %lsr.iv, align 8, !noalias !27
  %.3916.i = fadd double %.2874.i, %.3901.i
  store double %.3916.i, ptr %lsr.iv, align 8, !noalias !27
  %.3901.1.i = load double, ptr %sunkaddr45.i, align 8, !noalias !27
  %.3916.1.i = fadd double %.2937.i, %.3901.1.i
  store double %.3916.1.i, ptr %sunkaddr45.i, align 8, !noalias !27
  %.3901.2.i = load double, ptr %sunkaddr46.i, align 8, !noalias !27
  %.3916.2.i = fadd double %.3000.i, %.3901.2.i
  store double %.3916.2.i, ptr %sunkaddr46.i, align 8, !noalias !27
  %scevgep1.i = getelementptr i8, ptr %lsr.iv.i5, i64 %4
  %scevgep14.i19 = getelementptr i8, ptr %lsr.iv13.i, i64 %13
  %ov.i = icmp eq i64 %lsr.iv1.i, -1
  %lsr.iv.next.i20 = add nuw nsw i64 %lsr.iv1.i, 1
  br i1 %ov.i, label %part.3, label %switch.end.2.i

part.3: ; preds = %switch.end.2.i
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 %0
  %scevgep12 = getelementptr i8, ptr %lsr.iv11, i64 %arg.qdd.6.0
  %scevgep14 = getelementptr i8, ptr %lsr.iv13, i64 %arg.qd.6.0
  %scevgep16 = getelementptr i8, ptr %lsr.iv15, i64 %arg.q.6.0
  %lsr.iv.next = add nsw i64 %lsr.iv17, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not, label %B194, label %B62

B194:                                             ; preds = %part.3, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.follow(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.chain.0, ptr readnone captures(none) %arg.chain.1, i64 %arg.chain.2, i64 %arg.chain.3, ptr readonly captures(none) %arg.chain.4, i64 %arg.chain.5.0, i64 %arg.chain.5.1, i64 %arg.chain.6.0, i64 %arg.chain.6.1, ptr readnone captures(none) %arg.X_WO.0, ptr readnone captures(none) %arg.X_WO.1, i64 %arg.X_WO.2, i64 %arg.X_WO.3, ptr readonly captures(none) %arg.X_WO.4, i64 %arg.X_WO.5.0, i64 %arg.X_WO.5.1, i64 %arg.X_WO.6.0, i64 %arg.X_WO.6.1, ptr readnone captures(none) %arg.ride.0, ptr readnone captures(none) %arg.ride.1, i64 %arg.ride.2, i64 %arg.ride.3, ptr readonly captures(none) %arg.ride.4, i64 %arg.ride.5.0, i64 %arg.ride.6.0, ptr readnone captures(none) %arg.X_6T.0, ptr readnone captures(none) %arg.X_6T.1, i64 %arg.X_6T.2, i64 %arg.X_6T.3, ptr readonly captures(none) %arg.X_6T.4, i64 %arg.X_6T.5.0, i64 %arg.X_6T.5.1, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr readnone captures(none) %arg.room.0, ptr readnone captures(none) %arg.room.1, i64 %arg.room.2, i64 %arg.room.3, ptr %arg.room.4, i64 %arg.room.5.0, i64 %arg.room.5.1, i64 %arg.room.5.2, i64 %arg.room.6.0, i64 %arg.room.6.1, i64 %arg.room.6.2, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.6.0, i64 %arg.q.6.1, ptr readnone captures(none) %arg.twist.0, ptr readnone captures(none) %arg.twist.1, i64 %arg.twist.2, i64 %arg.twist.3, ptr readonly captures(none) %arg.twist.4, i64 %arg.twist.5.0, i64 %arg.twist.5.1, i64 %arg.twist.6.0, i64 %arg.twist.6.1, ptr readnone captures(none) %arg.bend.0, ptr readnone captures(none) %arg.bend.1, i64 %arg.bend.2, i64 %arg.bend.3, ptr readonly captures(none) %arg.bend.4, i64 %arg.bend.5.0, i64 %arg.bend.5.1, i64 %arg.bend.6.0, i64 %arg.bend.6.1, ptr readnone captures(none) %arg.rail_rate.0, ptr readnone captures(none) %arg.rail_rate.1, i64 %arg.rail_rate.2, i64 %arg.rail_rate.3, ptr readonly captures(none) %arg.rail_rate.4, i64 %arg.rail_rate.5.0, i64 %arg.rail_rate.5.1, i64 %arg.rail_rate.6.0, i64 %arg.rail_rate.6.1, ptr readnone captures(none) %arg.rail_bend.0, ptr readnone captures(none) %arg.rail_bend.1, i64 %arg.rail_bend.2, i64 %arg.rail_bend.3, ptr readonly captures(none) %arg.rail_bend.4, i64 %arg.rail_bend.5.0, i64 %arg.rail_bend.5.1, i64 %arg.rail_bend.6.0, i64 %arg.rail_bend.6.1, ptr readnone captures(none) %arg.qd.0, ptr readnone captures(none) %arg.qd.1, i64 %arg.qd.2, i64 %arg.qd.3, ptr captures(none) %arg.qd.4, i64 %arg.qd.5.0, i64 %arg.qd.5.1, i64 %arg.qd.6.0, i64 %arg.qd.6.1, ptr readnone captures(none) %arg.qdd.0, ptr readnone captures(none) %arg.qdd.1, i64 %arg.qdd.2, i64 %arg.qdd.3, ptr captures(none) %arg.qdd.4, i64 %arg.qdd.5.0, i64 %arg.qdd.5.1, i64 %arg.qdd.6.0, i64 %arg.qdd.6.1) local_unnamed_addr #0 {
B0.else.endif:
  %.2248 = alloca ptr, align 8
  %.3124 = alloca ptr, align 8
  %.259 = add nsw i64 %arg.q.5.1, -6
  %.330 = icmp slt i64 %arg.room.5.1, 1
  br i1 %.330, label %B0.endif.else.endif, label %B0.else.endif.endif.endif, !prof !30

B182:                                             ; preds = %B784.endif, %B182.lr.ph
  %lsr.iv152 = phi ptr [ %scevgep151, %B182.lr.ph ], [ %scevgep153, %B784.endif ]
  %lsr.iv145 = phi ptr [ %scevgep144, %B182.lr.ph ], [ %scevgep146, %B784.endif ]
  %lsr.iv137 = phi ptr [ %arg.rail_rate.4, %B182.lr.ph ], [ %scevgep138, %B784.endif ]
  %lsr.iv132 = phi ptr [ %arg.rail_bend.4, %B182.lr.ph ], [ %scevgep133, %B784.endif ]
  %lsr.iv126 = phi ptr [ %scevgep125, %B182.lr.ph ], [ %scevgep127, %B784.endif ]
  %lsr.iv120 = phi ptr [ %scevgep119, %B182.lr.ph ], [ %scevgep121, %B784.endif ]
  %lsr.iv110 = phi ptr [ %scevgep109, %B182.lr.ph ], [ %scevgep111, %B784.endif ]
  %lsr.iv = phi ptr [ %scevgep100, %B182.lr.ph ], [ %scevgep101, %B784.endif ]
  %.114610881156 = phi i64 [ 0, %B182.lr.ph ], [ %.1153, %B784.endif ]
  %0 = mul i64 %.114610881156, %arg.rail_rate.6.0
  %scevgep = getelementptr i8, ptr %arg.rail_rate.4, i64 %0
  %1 = mul i64 %.114610881156, %arg.rail_bend.6.0
  %scevgep69 = getelementptr i8, ptr %arg.rail_bend.4, i64 %1
  %.1153 = add nuw nsw i64 %.114610881156, 1
  %.1219 = mul i64 %.114610881156, %arg.q.6.0
  %.1221 = getelementptr i8, ptr %arg.q.4, i64 %.1219
  %.621.us.i = load double, ptr %invariant.gep1129.i, align 8, !noalias !31
  store double %.621.us.i, ptr %.342.i, align 8, !noalias !31
  br i1 %.678.not.i, label %B120.us.preheader.i, label %B120.preheader.i

B120.preheader.i:                                 ; preds = %B182
  %.766.i = load double, ptr %arg.ride.4, align 8, !noalias !31
  %.797.i = load double, ptr %.1221, align 8, !noalias !31
  %.798.i = fmul double %.766.i, %.797.i
  %.799.i = fadd double %.621.us.i, %.798.i
  store double %.799.i, ptr %.342.i, align 8, !noalias !31
  %.1022.i = load double, ptr %arg.X_WO.4, align 8, !noalias !31
  store double %.1022.i, ptr %arg.room.4, align 8, !noalias !31
  %.1022.1.i = load double, ptr %.1020.1.i, align 8, !noalias !31
  store double %.1022.1.i, ptr %93, align 8, !noalias !31
  %.1022.2.i = load double, ptr %.1020.2.i, align 8, !noalias !31
  store double %.1022.2.i, ptr %gep.2.i, align 8, !noalias !31
  %.621.1.i = load double, ptr %gep1130.1.i, align 8, !noalias !31
  store double %.621.1.i, ptr %sunkaddr24.i, align 8, !noalias !31
  %.766.1.i = load double, ptr %.764.1.i, align 8, !noalias !31
  %.797.1.i = load double, ptr %.1221, align 8, !noalias !31
  %.798.1.i = fmul double %.766.1.i, %.797.1.i
  %.799.1.i = fadd double %.621.1.i, %.798.1.i
  store double %.799.1.i, ptr %sunkaddr24.i, align 8, !noalias !31
  %.1022.11190.i = load double, ptr %131, align 8, !noalias !31
  store double %.1022.11190.i, ptr %.1904.1.i, align 8, !noalias !31
  %.1022.1.1.i = load double, ptr %.1020.1.1.i, align 8, !noalias !31
  store double %.1022.1.1.i, ptr %gep.1.1.i, align 8, !noalias !31
  %.1022.2.1.i = load double, ptr %.1020.2.1.i, align 8, !noalias !31
  store double %.1022.2.1.i, ptr %gep.2.1.i, align 8, !noalias !31
  %.621.2.i = load double, ptr %gep1130.2.i, align 8, !noalias !31
  store double %.621.2.i, ptr %sunkaddr26.i, align 8, !noalias !31
  %.766.2.i = load double, ptr %.764.2.i, align 8, !noalias !31
  %.797.2.i = load double, ptr %.1221, align 8, !noalias !31
  %.798.2.i = fmul double %.766.2.i, %.797.2.i
  %.799.2.i = fadd double %.621.2.i, %.798.2.i
  br label %B616.endif.2.peel.next.i

B120.us.preheader.i:                              ; preds = %B182
  %.1022.us.i = load double, ptr %arg.X_WO.4, align 8, !noalias !31
  store double %.1022.us.i, ptr %arg.room.4, align 8, !noalias !31
  %.1022.us.1.i = load double, ptr %.1020.1.i, align 8, !noalias !31
  store double %.1022.us.1.i, ptr %93, align 8, !noalias !31
  %.1022.us.2.i = load double, ptr %.1020.2.i, align 8, !noalias !31
  store double %.1022.us.2.i, ptr %gep.2.i, align 8, !noalias !31
  %.621.us.1.i = load double, ptr %gep1130.1.i, align 8, !noalias !31
  store double %.621.us.1.i, ptr %sunkaddr24.i, align 8, !noalias !31
  %.1022.us.11192.i = load double, ptr %131, align 8, !noalias !31
  store double %.1022.us.11192.i, ptr %.1904.1.i, align 8, !noalias !31
  %.1022.us.1.1.i = load double, ptr %.1020.1.1.i, align 8, !noalias !31
  store double %.1022.us.1.1.i, ptr %gep.1.1.i, align 8, !noalias !31
  %.1022.us.2.1.i = load double, ptr %.1020.2.1.i, align 8, !noalias !31
  store double %.1022.us.2.1.i, ptr %gep.2.1.i, align 8, !noalias !31
  %.621.us.2.i = load double, ptr %gep1130.2.i, align 8, !noalias !31
  br label %B616.endif.2.peel.next.i

B616.endif.2.peel.next.i:                         ; preds = %B120.us.preheader.i, %B120.preheader.i
  %storemerge = phi double [ %.799.2.i, %B120.preheader.i ], [ %.621.us.2.i, %B120.us.preheader.i ]
  store double %storemerge, ptr %sunkaddr26.i, align 8, !noalias !31
  %.1022.21191.i = load double, ptr %136, align 8, !noalias !31
  store double %.1022.21191.i, ptr %invariant.gep.2.i, align 8, !noalias !31
  %.1022.1.2.i = load double, ptr %.1020.1.2.i, align 8, !noalias !31
  store double %.1022.1.2.i, ptr %gep.1.2.i, align 8, !noalias !31
  %.1022.2.2.i = load double, ptr %.1020.2.2.i, align 8, !noalias !31
  store double %.1022.2.2.i, ptr %gep.2.2.i, align 8, !noalias !31
  %.1282.peel.i = load double, ptr %.1281.peel.i, align 8, !noalias !31
  %.1314.peel.i = getelementptr i8, ptr %.1221, i64 %.1312.peel.i
  %.1316.peel.i = load double, ptr %.1314.peel.i, align 8, !noalias !31
  %.1317.peel.i = fmul double %.1282.peel.i, %.1316.peel.i
  %.1372.peel.i = load double, ptr %.1371.peel.i, align 8, !noalias !31
  %.1373.peel.i = fadd double %.1317.peel.i, %.1372.peel.i
  %.1428.peel.i = load double, ptr %.1427.peel.i, align 8, !noalias !31
  %.1430.peel.i = fmul double %.1428.peel.i, 0.000000e+00
  %.1433.peel.i = fsub double %.1373.peel.i, %.1430.peel.i
  %.1471.peel.i = tail call double @llvm.cos.f64(double %.1433.peel.i)
  %.1472.peel.i = tail call double @llvm.sin.f64(double %.1433.peel.i)
  %.1533.peel.i = load double, ptr %arg.chain.4, align 8, !noalias !31
  %.5.i.peel.i = fptosi double %.1533.peel.i to i64
  %.1562.peel.i = add nsw i64 %.5.i.peel.i, 1
  %.1582.peel.i = srem i64 %.1562.peel.i, 3
  %.1584.peel.i = icmp slt i64 %.1582.peel.i, 0
  %.1593.peel.i = add nsw i64 %.1582.peel.i, 3
  %.1573.1.peel.i = select i1 %.1584.peel.i, i64 %.1593.peel.i, i64 %.1582.peel.i
  %.1604.peel.i = add nsw i64 %.5.i.peel.i, 2
  %.1624.peel.i = srem i64 %.1604.peel.i, 3
  %.1626.peel.i = icmp slt i64 %.1624.peel.i, 0
  %.1635.peel.i = add nsw i64 %.1624.peel.i, 3
  %.1615.1.peel.i = select i1 %.1626.peel.i, i64 %.1635.peel.i, i64 %.1624.peel.i
  %.2265.peel.i = icmp slt i64 %.5.i.peel.i, 0
  %.2266.peel.i = select i1 %.2265.peel.i, i64 %arg.room.5.1, i64 0
  %.2267.peel.i = add i64 %.2266.peel.i, %.5.i.peel.i
  %.2287.peel.i = mul i64 %.2267.peel.i, %arg.room.5.2
  %2 = getelementptr double, ptr %arg.room.4, i64 %.2287.peel.i
  %.1849.peel.i = load double, ptr %.342.i, align 8, !noalias !31
  %.1905.peel.i = load double, ptr %arg.room.4, align 8, !noalias !31
  %.1960.peel.i = load double, ptr %.1959.peel.i, align 8, !noalias !31
  %.1961.peel.i = fmul double %.1905.peel.i, %.1960.peel.i
  %.1962.peel.i = fadd double %.1849.peel.i, %.1961.peel.i
  %.2016.peel.i = load double, ptr %93, align 8, !noalias !31
  %.2071.peel.i = load double, ptr %.2070.peel.i, align 8, !noalias !31
  %.2072.peel.i = fmul double %.2016.peel.i, %.2071.peel.i
  %.2073.peel.i = fadd double %.1962.peel.i, %.2072.peel.i
  %.2127.peel.i = load double, ptr %94, align 8, !noalias !31
  %.2182.peel.i = load double, ptr %.2181.peel.i, align 8, !noalias !31
  %.2183.peel.i = fmul double %.2127.peel.i, %.2182.peel.i
  %.2184.peel.i = fadd double %.2073.peel.i, %.2183.peel.i
  store double %.2184.peel.i, ptr %.342.i, align 8, !noalias !31
  %.2292.peel.i = load double, ptr %2, align 8, !noalias !31
  store double %.2292.peel.i, ptr %sunkaddr55.i, align 8, !noalias !31
  %.1849.1.peel.i = load double, ptr %sunkaddr24.i, align 8, !noalias !31
  %.1905.1.peel.i = load double, ptr %.1904.1.i, align 8, !noalias !31
  %.1960.1.peel.i = load double, ptr %.1959.peel.i, align 8, !noalias !31
  %.1961.1.peel.i = fmul double %.1905.1.peel.i, %.1960.1.peel.i
  %.1962.1.peel.i = fadd double %.1849.1.peel.i, %.1961.1.peel.i
  %.2016.1.peel.i = load double, ptr %.2015.1.i, align 8, !noalias !31
  %.2071.1.peel.i = load double, ptr %.2070.peel.i, align 8, !noalias !31
  %.2072.1.peel.i = fmul double %.2016.1.peel.i, %.2071.1.peel.i
  %.2073.1.peel.i = fadd double %.1962.1.peel.i, %.2072.1.peel.i
  %.2127.1.peel.i = load double, ptr %.2126.1.i, align 8, !noalias !31
  %.2182.1.peel.i = load double, ptr %.2181.peel.i, align 8, !noalias !31
  %.2183.1.peel.i = fmul double %.2127.1.peel.i, %.2182.1.peel.i
  %.2184.1.peel.i = fadd double %.2073.1.peel.i, %.2183.1.peel.i
  store double %.2184.1.peel.i, ptr %sunkaddr24.i, align 8, !noalias !31
  %.2291.1.peel.i = getelementptr i8, ptr %2, i64 8
  %.2292.1.peel.i = load double, ptr %.2291.1.peel.i, align 8, !noalias !31
  store double %.2292.1.peel.i, ptr %sunkaddr60.i, align 8, !noalias !31
  %.1849.2.peel.i = load double, ptr %sunkaddr26.i, align 8, !noalias !31
  %.1905.2.peel.i = load double, ptr %invariant.gep.2.i, align 8, !noalias !31
  %.1960.2.peel.i = load double, ptr %.1959.peel.i, align 8, !noalias !31
  %.1961.2.peel.i = fmul double %.1905.2.peel.i, %.1960.2.peel.i
  %.1962.2.peel.i = fadd double %.1849.2.peel.i, %.1961.2.peel.i
  %.2016.2.peel.i = load double, ptr %.2015.2.i, align 8, !noalias !31
  %.2071.2.peel.i = load double, ptr %.2070.peel.i, align 8, !noalias !31
  %.2072.2.peel.i = fmul double %.2016.2.peel.i, %.2071.2.peel.i
  %.2073.2.peel.i = fadd double %.1962.2.peel.i, %.2072.2.peel.i
  %.2127.2.peel.i = load double, ptr %.2126.2.i, align 8, !noalias !31
  %.2182.2.peel.i = load double, ptr %.2181.peel.i, align 8, !noalias !31
  %.2183.2.peel.i = fmul double %.2127.2.peel.i, %.2182.2.peel.i
  %.2184.2.peel.i = fadd double %.2073.2.peel.i, %.2183.2.peel.i
  store double %.2184.2.peel.i, ptr %sunkaddr26.i, align 8, !noalias !31
  %.2291.2.peel.i = getelementptr i8, ptr %2, i64 16
  %.2292.2.peel.i = load double, ptr %.2291.2.peel.i, align 8, !noalias !31
  store double %.2292.2.peel.i, ptr %sunkaddr65.i, align 8, !noalias !31
  %.2501.peel.i = icmp slt i64 %.1573.1.peel.i, 0
  %.2502.peel.i = select i1 %.2501.peel.i, i64 %arg.room.5.1, i64 0
  %.2503.peel.i = add i64 %.2502.peel.i, %.1573.1.peel.i
  %.2523.peel.i = mul i64 %.2503.peel.i, %arg.room.5.2
  %3 = getelementptr double, ptr %arg.room.4, i64 %.2523.peel.i
  %.2556.peel.i = icmp slt i64 %.1615.1.peel.i, 0
  %.2557.peel.i = select i1 %.2556.peel.i, i64 %arg.room.5.1, i64 0
  %.2558.peel.i = add i64 %.2557.peel.i, %.1615.1.peel.i
  %.2578.peel.i = mul i64 %.2558.peel.i, %arg.room.5.2
  %4 = getelementptr double, ptr %arg.room.4, i64 %.2578.peel.i
  %.2528.peel.i = load double, ptr %3, align 8, !noalias !31
  %.2583.peel.i = load double, ptr %4, align 8, !noalias !31
  %.2587.peel.i = fmul double %.1471.peel.i, %.2528.peel.i
  %.2589.peel.i = fmul double %.1472.peel.i, %.2583.peel.i
  %.2590.peel.i = fadd double %.2587.peel.i, %.2589.peel.i
  %.2592.peel.i = fmul double %.1471.peel.i, %.2583.peel.i
  %.2594.peel.i = fmul double %.1472.peel.i, %.2528.peel.i
  %.2595.peel.i = fsub double %.2592.peel.i, %.2594.peel.i
  store double %.2590.peel.i, ptr %3, align 8, !noalias !31
  store double %.2595.peel.i, ptr %4, align 8, !noalias !31
  %.2527.1.peel.i = getelementptr i8, ptr %3, i64 8
  %.2528.1.peel.i = load double, ptr %.2527.1.peel.i, align 8, !noalias !31
  %.2582.1.peel.i = getelementptr i8, ptr %4, i64 8
  %.2583.1.peel.i = load double, ptr %.2582.1.peel.i, align 8, !noalias !31
  %.2587.1.peel.i = fmul double %.1471.peel.i, %.2528.1.peel.i
  %.2589.1.peel.i = fmul double %.1472.peel.i, %.2583.1.peel.i
  %.2590.1.peel.i = fadd double %.2587.1.peel.i, %.2589.1.peel.i
  %.2592.1.peel.i = fmul double %.1471.peel.i, %.2583.1.peel.i
  %.2594.1.peel.i = fmul double %.1472.peel.i, %.2528.1.peel.i
  %.2595.1.peel.i = fsub double %.2592.1.peel.i, %.2594.1.peel.i
  store double %.2590.1.peel.i, ptr %.2527.1.peel.i, align 8, !noalias !31
  store double %.2595.1.peel.i, ptr %.2582.1.peel.i, align 8, !noalias !31
  %.2527.2.peel.i = getelementptr i8, ptr %3, i64 16
  %.2528.2.peel.i = load double, ptr %.2527.2.peel.i, align 8, !noalias !31
  %.2582.2.peel.i = getelementptr i8, ptr %4, i64 16
  %.2583.2.peel.i = load double, ptr %.2582.2.peel.i, align 8, !noalias !31
  %.2587.2.peel.i = fmul double %.1471.peel.i, %.2528.2.peel.i
  %.2589.2.peel.i = fmul double %.1472.peel.i, %.2583.2.peel.i
  %.2590.2.peel.i = fadd double %.2587.2.peel.i, %.2589.2.peel.i
  %.2592.2.peel.i = fmul double %.1471.peel.i, %.2583.2.peel.i
  %.2594.2.peel.i = fmul double %.1472.peel.i, %.2528.2.peel.i
  %.2595.2.peel.i = fsub double %.2592.2.peel.i, %.2594.2.peel.i
  store double %.2590.2.peel.i, ptr %.2527.2.peel.i, align 8, !noalias !31
  store double %.2595.2.peel.i, ptr %.2582.2.peel.i, align 8, !noalias !31
  br label %B616.endif.2.i

B616.endif.2.i:                                   ; preds = %B616.endif.2.i, %B616.endif.2.peel.next.i
  %lsr.iv37.i = phi i64 [ 5, %B616.endif.2.peel.next.i ], [ %lsr.iv.next38.i, %B616.endif.2.i ]
  %lsr.iv35.i = phi i64 [ %107, %B616.endif.2.peel.next.i ], [ %lsr.iv.next36.i, %B616.endif.2.i ]
  %lsr.iv27.i = phi ptr [ %scevgep26.i, %B616.endif.2.peel.next.i ], [ %scevgep28.i, %B616.endif.2.i ]
  %lsr.iv19.i = phi i64 [ %104, %B616.endif.2.peel.next.i ], [ %lsr.iv.next20.i, %B616.endif.2.i ]
  %lsr.iv12.i = phi i64 [ %100, %B616.endif.2.peel.next.i ], [ %lsr.iv.next13.i, %B616.endif.2.i ]
  %lsr.iv.i = phi i64 [ %95, %B616.endif.2.peel.next.i ], [ %lsr.iv.next.i, %B616.endif.2.i ]
  %before.2.01171.i = phi double [ %.1316.peel.i, %B616.endif.2.peel.next.i ], [ %.1316.i, %B616.endif.2.i ]
  %scevgep32.i = getelementptr i8, ptr %lsr.iv27.i, i64 -48
  %scevgep34.i = getelementptr i8, ptr %lsr.iv27.i, i64 -40
  %.1282.i = load double, ptr %scevgep34.i, align 8, !noalias !31
  %.1299.i = icmp slt i64 %lsr.iv35.i, 0
  %.1300.i = select i1 %.1299.i, i64 %arg.q.5.1, i64 0
  %5 = add i64 %.1300.i, %lsr.iv35.i
  %.1312.i = mul i64 %5, %arg.q.6.1
  %.1314.i = getelementptr i8, ptr %.1221, i64 %.1312.i
  %.1316.i = load double, ptr %.1314.i, align 8, !noalias !31
  %.1317.i = fmul double %.1282.i, %.1316.i
  %scevgep33.i = getelementptr i8, ptr %lsr.iv27.i, i64 -32
  %.1372.i = load double, ptr %scevgep33.i, align 8, !noalias !31
  %.1373.i = fadd double %.1317.i, %.1372.i
  %.1428.i = load double, ptr %lsr.iv27.i, align 8, !noalias !31
  %.1430.i = fmul double %before.2.01171.i, %.1428.i
  %.1433.i = fsub double %.1373.i, %.1430.i
  %.1471.i = tail call double @llvm.cos.f64(double %.1433.i)
  %.1472.i = tail call double @llvm.sin.f64(double %.1433.i)
  %.1533.i = load double, ptr %scevgep32.i, align 8, !noalias !31
  %.5.i.i = fptosi double %.1533.i to i64
  %.1562.i = add nsw i64 %.5.i.i, 1
  %.1582.i = srem i64 %.1562.i, 3
  %.1584.i = icmp slt i64 %.1582.i, 0
  %.1593.i = add nsw i64 %.1582.i, 3
  %.1573.1.i = select i1 %.1584.i, i64 %.1593.i, i64 %.1582.i
  %.1604.i = add nsw i64 %.5.i.i, 2
  %.1624.i = srem i64 %.1604.i, 3
  %.1626.i = icmp slt i64 %.1624.i, 0
  %.1635.i = add nsw i64 %.1624.i, 3
  %.1615.1.i = select i1 %.1626.i, i64 %.1635.i, i64 %.1624.i
  %scevgep31.i = getelementptr i8, ptr %lsr.iv27.i, i64 -24
  %scevgep30.i = getelementptr i8, ptr %lsr.iv27.i, i64 -16
  %scevgep29.i = getelementptr i8, ptr %lsr.iv27.i, i64 -8
  %.2265.i = icmp slt i64 %.5.i.i, 0
  %.2266.i = select i1 %.2265.i, i64 %arg.room.5.1, i64 0
  %.2267.i = add i64 %.2266.i, %.5.i.i
  %.2287.i = mul i64 %.2267.i, %arg.room.5.2
  %6 = getelementptr double, ptr %arg.room.4, i64 %.2287.i
  %scevgep10.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv.i
  %scevgep11.i = getelementptr i8, ptr %scevgep10.i, i64 -16
  %.1849.i = load double, ptr %scevgep11.i, align 8, !noalias !31
  %.1905.i = load double, ptr %arg.room.4, align 8, !noalias !31
  %.1960.i = load double, ptr %scevgep31.i, align 8, !noalias !31
  %.1961.i = fmul double %.1905.i, %.1960.i
  %.1962.i = fadd double %.1849.i, %.1961.i
  %.2016.i = load double, ptr %sunkaddr28.i, align 8, !noalias !31
  %.2071.i = load double, ptr %scevgep30.i, align 8, !noalias !31
  %.2072.i = fmul double %.2016.i, %.2071.i
  %.2073.i = fadd double %.1962.i, %.2072.i
  %.2127.i = load double, ptr %94, align 8, !noalias !31
  %.2182.i = load double, ptr %scevgep29.i, align 8, !noalias !31
  %.2183.i = fmul double %.2127.i, %.2182.i
  %.2184.i = fadd double %.2073.i, %.2183.i
  %scevgep14.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv12.i
  %scevgep15.i = getelementptr i8, ptr %scevgep14.i, i64 -16
  store double %.2184.i, ptr %scevgep15.i, align 8, !noalias !31
  %.2292.i = load double, ptr %6, align 8, !noalias !31
  %scevgep21.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv19.i
  %scevgep22.i = getelementptr i8, ptr %scevgep21.i, i64 -16
  store double %.2292.i, ptr %scevgep22.i, align 8, !noalias !31
  %scevgep7.i = getelementptr i8, ptr %scevgep10.i, i64 -8
  %.1849.1.i = load double, ptr %scevgep7.i, align 8, !noalias !31
  %.1905.1.i = load double, ptr %.1904.1.i, align 8, !noalias !31
  %.1960.1.i = load double, ptr %scevgep31.i, align 8, !noalias !31
  %.1961.1.i = fmul double %.1905.1.i, %.1960.1.i
  %.1962.1.i = fadd double %.1849.1.i, %.1961.1.i
  %.2016.1.i = load double, ptr %sunkaddr33.i, align 8, !noalias !31
  %.2071.1.i = load double, ptr %scevgep30.i, align 8, !noalias !31
  %.2072.1.i = fmul double %.2016.1.i, %.2071.1.i
  %.2073.1.i = fadd double %.1962.1.i, %.2072.1.i
  %.2127.1.i = load double, ptr %.2126.1.i, align 8, !noalias !31
  %.2182.1.i = load double, ptr %scevgep29.i, align 8, !noalias !31
  %.2183.1.i = fmul double %.2127.1.i, %.2182.1.i
  %.2184.1.i = fadd double %.2073.1.i, %.2183.1.i
  %scevgep5.i = getelementptr i8, ptr %scevgep14.i, i64 -8
  store double %.2184.1.i, ptr %scevgep5.i, align 8, !noalias !31
  %.2291.1.i = getelementptr i8, ptr %6, i64 8
  %.2292.1.i = load double, ptr %.2291.1.i, align 8, !noalias !31
  %scevgep3.i = getelementptr i8, ptr %scevgep21.i, i64 -8
  store double %.2292.1.i, ptr %scevgep3.i, align 8, !noalias !31
  %.1849.2.i = load double, ptr %scevgep10.i, align 8, !noalias !31
  %.1905.2.i = load double, ptr %invariant.gep.2.i, align 8, !noalias !31
  %.1960.2.i = load double, ptr %scevgep31.i, align 8, !noalias !31
  %.1961.2.i = fmul double %.1905.2.i, %.1960.2.i
  %.1962.2.i = fadd double %.1849.2.i, %.1961.2.i
  %.2016.2.i = load double, ptr %sunkaddr39.i, align 8, !noalias !31
  %.2071.2.i = load double, ptr %scevgep30.i, align 8, !noalias !31
  %.2072.2.i = fmul double %.2016.2.i, %.2071.2.i
  %.2073.2.i = fadd double %.1962.2.i, %.2072.2.i
  %.2127.2.i = load double, ptr %.2126.2.i, align 8, !noalias !31
  %.2182.2.i = load double, ptr %scevgep29.i, align 8, !noalias !31
  %.2183.2.i = fmul double %.2127.2.i, %.2182.2.i
  %.2184.2.i = fadd double %.2073.2.i, %.2183.2.i
  store double %.2184.2.i, ptr %scevgep14.i, align 8, !noalias !31
  %.2291.2.i = getelementptr i8, ptr %6, i64 16
  %.2292.2.i = load double, ptr %.2291.2.i, align 8, !noalias !31
  store double %.2292.2.i, ptr %scevgep21.i, align 8, !noalias !31
  %.2501.i = icmp slt i64 %.1573.1.i, 0
  %.2502.i = select i1 %.2501.i, i64 %arg.room.5.1, i64 0
  %.2503.i = add i64 %.2502.i, %.1573.1.i
  %.2523.i = mul i64 %.2503.i, %arg.room.5.2
  %7 = getelementptr double, ptr %arg.room.4, i64 %.2523.i
  %.2556.i = icmp slt i64 %.1615.1.i, 0
  %.2557.i = select i1 %.2556.i, i64 %arg.room.5.1, i64 0
  %.2558.i = add i64 %.2557.i, %.1615.1.i
  %.2578.i = mul i64 %.2558.i, %arg.room.5.2
  %8 = getelementptr double, ptr %arg.room.4, i64 %.2578.i
  %.2528.i = load double, ptr %7, align 8, !noalias !31
  %.2583.i = load double, ptr %8, align 8, !noalias !31
  %.2587.i = fmul double %.1471.i, %.2528.i
  %.2589.i = fmul double %.1472.i, %.2583.i
  %.2590.i = fadd double %.2587.i, %.2589.i
  %.2592.i = fmul double %.1471.i, %.2583.i
  %.2594.i = fmul double %.1472.i, %.2528.i
  %.2595.i = fsub double %.2592.i, %.2594.i
  store double %.2590.i, ptr %7, align 8, !noalias !31
  store double %.2595.i, ptr %8, align 8, !noalias !31
  %.2527.1.i = getelementptr i8, ptr %7, i64 8
  %.2528.1.i = load double, ptr %.2527.1.i, align 8, !noalias !31
  %.2582.1.i = getelementptr i8, ptr %8, i64 8
  %.2583.1.i = load double, ptr %.2582.1.i, align 8, !noalias !31
  %.2587.1.i = fmul double %.1471.i, %.2528.1.i
  %.2589.1.i = fmul double %.1472.i, %.2583.1.i
  %.2590.1.i = fadd double %.2587.1.i, %.2589.1.i
  %.2592.1.i = fmul double %.1471.i, %.2583.1.i
  %.2594.1.i = fmul double %.1472.i, %.2528.1.i
  %.2595.1.i = fsub double %.2592.1.i, %.2594.1.i
  store double %.2590.1.i, ptr %.2527.1.i, align 8, !noalias !31
  store double %.2595.1.i, ptr %.2582.1.i, align 8, !noalias !31
  %.2527.2.i = getelementptr i8, ptr %7, i64 16
  %.2528.2.i = load double, ptr %.2527.2.i, align 8, !noalias !31
  %.2582.2.i = getelementptr i8, ptr %8, i64 16
  %.2583.2.i = load double, ptr %.2582.2.i, align 8, !noalias !31
  %.2587.2.i = fmul double %.1471.i, %.2528.2.i
  %.2589.2.i = fmul double %.1472.i, %.2583.2.i
  %.2590.2.i = fadd double %.2587.2.i, %.2589.2.i
  %.2592.2.i = fmul double %.1471.i, %.2583.2.i
  %.2594.2.i = fmul double %.1472.i, %.2528.2.i
  %.2595.2.i = fsub double %.2592.2.i, %.2594.2.i
  store double %.2590.2.i, ptr %.2527.2.i, align 8, !noalias !31
  store double %.2595.2.i, ptr %.2582.2.i, align 8, !noalias !31
  %lsr.iv.next.i = add i64 %lsr.iv.i, %96
  %lsr.iv.next13.i = add i64 %lsr.iv12.i, %96
  %lsr.iv.next20.i = add i64 %lsr.iv19.i, %96
  %scevgep28.i = getelementptr i8, ptr %lsr.iv27.i, i64 %105
  %lsr.iv.next36.i = add i64 %lsr.iv35.i, 1
  %lsr.iv.next38.i = add nsw i64 %lsr.iv37.i, -1
  %exitcond.not.i = icmp eq i64 %lsr.iv.next38.i, 0
  br i1 %exitcond.not.i, label %part.0, label %B616.endif.2.i, !llvm.loop !34

part.0: ; preds = %B616.endif.2.i
  %.2922.i = load double, ptr %108, align 8, !noalias !31
  %.2976.i = load double, ptr %arg.room.4, align 8, !noalias !31
  %.3030.i = load double, ptr %.3028.i, align 8, !noalias !31
  %.3031.i = fmul double %.2976.i, %.3030.i
  %.3032.i = fadd double %.2922.i, %.3031.i
  %.3086.i = load double, ptr %sunkaddr28.i, align 8, !noalias !31
  %.3140.i = load double, ptr %.3138.i, align 8, !noalias !31
  %.3141.i = fmul double %.3086.i, %.3140.i
  %.3142.i = fadd double %.3032.i, %.3141.i
  %.3196.i = load double, ptr %94, align 8, !noalias !31
  %.3250.i = load double, ptr %.3248.i, align 8, !noalias !31
  %.3251.i = fmul double %.3196.i, %.3250.i
  %.3252.i = fadd double %.3142.i, %.3251.i
  store double %.3252.i, ptr %111, align 8, !noalias !31
  %.2922.1.i = load double, ptr %.2921.1.i, align 8, !noalias !31
  %.2976.1.i = load double, ptr %.1904.1.i, align 8, !noalias !31
  %.3030.1.i = load double, ptr %.3028.i, align 8, !noalias !31
  %.3031.1.i = fmul double %.2976.1.i, %.3030.1.i
  %.3032.1.i = fadd double %.2922.1.i, %.3031.1.i
  %.3086.1.i = load double, ptr %sunkaddr33.i, align 8, !noalias !31
  %.3140.1.i = load double, ptr %.3138.i, align 8, !noalias !31
  %.3141.1.i = fmul double %.3086.1.i, %.3140.1.i
  %.3142.1.i = fadd double %.3032.1.i, %.3141.1.i
  %.3196.1.i = load double, ptr %.2126.1.i, align 8, !noalias !31
  %.3250.1.i = load double, ptr %.3248.i, align 8, !noalias !31
  %.3251.1.i = fmul double %.3196.1.i, %.3250.1.i
  %.3252.1.i = fadd double %.3142.1.i, %.3251.1.i
  store double %.3252.1.i, ptr %.3305.1.i, align 8, !noalias !31
  %.2922.2.i = load double, ptr %.2921.2.i, align 8, !noalias !31
  %.2976.2.i = load double, ptr %invariant.gep.2.i, align 8, !noalias !31
  %.3030.2.i = load double, ptr %.3028.i, align 8, !noalias !31
  %.3031.2.i = fmul double %.2976.2.i, %.3030.2.i
  %.3032.2.i = fadd double %.2922.2.i, %.3031.2.i
  %.3086.2.i = load double, ptr %sunkaddr39.i, align 8, !noalias !31
  %.3140.2.i = load double, ptr %.3138.i, align 8, !noalias !31
  %.3141.2.i = fmul double %.3086.2.i, %.3140.2.i
  %.3142.2.i = fadd double %.3032.2.i, %.3141.2.i
  %.3196.2.i = load double, ptr %.2126.2.i, align 8, !noalias !31
  %.3250.2.i = load double, ptr %.3248.i, align 8, !noalias !31
  %.3251.2.i = fmul double %.3196.2.i, %.3250.2.i
  %.3252.2.i = fadd double %.3142.2.i, %.3251.2.i
  store double %.3252.2.i, ptr %.3305.2.i, align 8, !noalias !31
  %.511.peel.i = load double, ptr %.342.i, align 8, !noalias !35
  %.512.peel.i = fsub double %.3252.i, %.511.peel.i
  %.621.peel.i = load double, ptr %sunkaddr24.i, align 8, !noalias !35
  %.622.peel.i = fsub double %.3252.1.i, %.621.peel.i
  %.731.peel.i = load double, ptr %sunkaddr26.i, align 8, !noalias !35
  %.732.peel.i = fsub double %.3252.2.i, %.731.peel.i
  %.787.peel.i = load double, ptr %.786.peel.i, align 8, !noalias !35
  %.788.peel.i = fmul double %.787.peel.i, %.732.peel.i
  %.843.peel.i = load double, ptr %.842.peel.i, align 8, !noalias !35
  %.844.peel.i = fmul double %.622.peel.i, %.843.peel.i
  %.845.peel.i = fsub double %.788.peel.i, %.844.peel.i
  %.901.peel.i = fmul double %.512.peel.i, %.843.peel.i
  %.956.peel.i = load double, ptr %.121.i, align 8, !noalias !35
  %.957.peel.i = fmul double %.732.peel.i, %.956.peel.i
  %.958.peel.i = fsub double %.901.peel.i, %.957.peel.i
  %.1014.peel.i = fmul double %.622.peel.i, %.956.peel.i
  %.1070.peel.i = fmul double %.512.peel.i, %.787.peel.i
  %.1071.peel.i = fsub double %.1014.peel.i, %.1070.peel.i
  %.1258.peel.i = load double, ptr %.1281.peel.i, align 8, !noalias !35
  %.1274.peel.i = fmul double %.1258.peel.i, %.845.peel.i
  %.1386.peel.i = fmul double %.956.peel.i, %.1258.peel.i
  store double %.1274.peel.i, ptr %.438, align 8, !noalias !35
  store double %.1386.peel.i, ptr %gep709.peel.i, align 8, !noalias !35
  %.1558.peel.i = load double, ptr %.1427.peel.i, align 8, !noalias !35
  %.1560.peel.i = fcmp une double %.1558.peel.i, 0.000000e+00
  br i1 %.1560.peel.i, label %switch.end.1.peel.i, label %switch.end.1727.peel.i

switch.end.1.peel.i:                              ; preds = %part.0
  %.1618.peel.i = load double, ptr %invariant.gep710.peel.i, align 8, !noalias !35
  %.1689.peel.i = fmul double %.845.peel.i, %.1558.peel.i
  %.1690.peel.i = fsub double %.1618.peel.i, %.1689.peel.i
  store double %.1690.peel.i, ptr %invariant.gep710.peel.i, align 8, !noalias !35
  %.1798.peel.i = load double, ptr %gep713.peel.i, align 8, !noalias !35
  %.1853.peel.i = load double, ptr %.1427.peel.i, align 8, !noalias !35
  %.1909.peel.i = load double, ptr %sunkaddr55.i, align 8, !noalias !35
  %.1912.peel.i = fmul double %.1853.peel.i, %.1909.peel.i
  %.1913.peel.i = fsub double %.1798.peel.i, %.1912.peel.i
  store double %.1913.peel.i, ptr %gep713.peel.i, align 8, !noalias !35
  br label %switch.end.1727.peel.i

switch.end.1727.peel.i:                           ; preds = %part.0, %switch.end.1.peel.i
  %.1258.1.peel.i = load double, ptr %.1281.peel.i, align 8, !noalias !35
  %.1274.1.peel.i = fmul double %.958.peel.i, %.1258.1.peel.i
  %.1383.1.peel.i = load double, ptr %sunkaddr60.i, align 8, !noalias !35
  %.1386.1.peel.i = fmul double %.1258.1.peel.i, %.1383.1.peel.i
  store double %.1274.1.peel.i, ptr %gep.1.peel.i, align 8, !noalias !35
  store double %.1386.1.peel.i, ptr %gep709.1.peel.i, align 8, !noalias !35
  %.1558.1.peel.i = load double, ptr %.1427.peel.i, align 8, !noalias !35
  %.1560.1.peel.i = fcmp une double %.1558.1.peel.i, 0.000000e+00
  br i1 %.1560.1.peel.i, label %switch.end.1.1.peel.i, label %switch.end.2.peel.i

switch.end.1.1.peel.i:                            ; preds = %switch.end.1727.peel.i
  %.1618.1.peel.i = load double, ptr %gep711.1.peel.i, align 8, !noalias !35
  %.1689.1.peel.i = fmul double %.958.peel.i, %.1558.1.peel.i
  %.1690.1.peel.i = fsub double %.1618.1.peel.i, %.1689.1.peel.i
  store double %.1690.1.peel.i, ptr %gep711.1.peel.i, align 8, !noalias !35
  %.1798.1.peel.i = load double, ptr %gep713.1.peel.i, align 8, !noalias !35
  %.1853.1.peel.i = load double, ptr %.1427.peel.i, align 8, !noalias !35
  %.1909.1.peel.i = load double, ptr %sunkaddr60.i, align 8, !noalias !35
  %.1912.1.peel.i = fmul double %.1853.1.peel.i, %.1909.1.peel.i
  %.1913.1.peel.i = fsub double %.1798.1.peel.i, %.1912.1.peel.i
  store double %.1913.1.peel.i, ptr %gep713.1.peel.i, align 8, !noalias !35
  br label %switch.end.2.peel.i

switch.end.2.peel.i:                              ; preds = %switch.end.1.1.peel.i, %switch.end.1727.peel.i
  %.1258.2.peel.i = load double, ptr %.1281.peel.i, align 8, !noalias !35
  %.1274.2.peel.i = fmul double %.1071.peel.i, %.1258.2.peel.i
  %.1383.2.peel.i = load double, ptr %sunkaddr65.i, align 8, !noalias !35
  %.1386.2.peel.i = fmul double %.1258.2.peel.i, %.1383.2.peel.i
  store double %.1274.2.peel.i, ptr %gep.2.peel.i, align 8, !noalias !35
  store double %.1386.2.peel.i, ptr %gep709.2.peel.i, align 8, !noalias !35
  %.1558.2.peel.i = load double, ptr %.1427.peel.i, align 8, !noalias !35
  %.1560.2.peel.i = fcmp une double %.1558.2.peel.i, 0.000000e+00
  br i1 %.1560.2.peel.i, label %switch.end.1.2.peel.i, label %switch.end.i.preheader

switch.end.1.2.peel.i:                            ; preds = %switch.end.2.peel.i
  %.1618.2.peel.i = load double, ptr %gep711.2.peel.i, align 8, !noalias !35
  %.1689.2.peel.i = fmul double %.1071.peel.i, %.1558.2.peel.i
  %.1690.2.peel.i = fsub double %.1618.2.peel.i, %.1689.2.peel.i
  store double %.1690.2.peel.i, ptr %gep711.2.peel.i, align 8, !noalias !35
  %.1798.2.peel.i = load double, ptr %gep713.2.peel.i, align 8, !noalias !35
  %.1853.2.peel.i = load double, ptr %.1427.peel.i, align 8, !noalias !35
  %.1909.2.peel.i = load double, ptr %sunkaddr65.i, align 8, !noalias !35
  %.1912.2.peel.i = fmul double %.1853.2.peel.i, %.1909.2.peel.i
  %.1913.2.peel.i = fsub double %.1798.2.peel.i, %.1912.2.peel.i
  store double %.1913.2.peel.i, ptr %gep713.2.peel.i, align 8, !noalias !35
  br label %switch.end.i.preheader

switch.end.i.preheader:                           ; preds = %switch.end.1.2.peel.i, %switch.end.2.peel.i
  br label %switch.end.i

switch.end.1727.i:                                ; preds = %switch.end.1.i, %switch.end.i
  %.1258.1.i = load double, ptr %scevgep3.i7, align 8, !noalias !35
  %.1274.1.i = fmul double %.958.i, %.1258.1.i
  %.1383.1.i = load double, ptr %scevgep9.i, align 8, !noalias !35
  %.1386.1.i = fmul double %.1258.1.i, %.1383.1.i
  %scevgep43.i = getelementptr i8, ptr %scevgep41.i, i64 %lsr.iv21.i
  %scevgep44.i = getelementptr i8, ptr %scevgep43.i, i64 8
  store double %.1274.1.i, ptr %scevgep44.i, align 8, !noalias !35
  %scevgep28.i8 = getelementptr i8, ptr %scevgep26.i2, i64 %lsr.iv21.i
  %scevgep29.i9 = getelementptr i8, ptr %scevgep28.i8, i64 8
  store double %.1386.1.i, ptr %scevgep29.i9, align 8, !noalias !35
  %.1558.1.i = load double, ptr %lsr.iv.i4, align 8, !noalias !35
  %.1560.1.i = fcmp une double %.1558.1.i, 0.000000e+00
  br i1 %.1560.1.i, label %switch.end.1.1.i, label %switch.end.2.i

switch.end.1.1.i:                                 ; preds = %switch.end.1727.i
  %.1618.1.i = load double, ptr %scevgep43.i, align 8, !noalias !35
  %.1689.1.i = fmul double %.958.i, %.1558.1.i
  %.1690.1.i = fsub double %.1618.1.i, %.1689.1.i
  store double %.1690.1.i, ptr %scevgep43.i, align 8, !noalias !35
  %.1798.1.i = load double, ptr %scevgep28.i8, align 8, !noalias !35
  %.1853.1.i = load double, ptr %lsr.iv.i4, align 8, !noalias !35
  %.1909.1.i = load double, ptr %scevgep9.i, align 8, !noalias !35
  %.1912.1.i = fmul double %.1853.1.i, %.1909.1.i
  %.1913.1.i = fsub double %.1798.1.i, %.1912.1.i
  store double %.1913.1.i, ptr %scevgep28.i8, align 8, !noalias !35
  br label %switch.end.2.i

switch.end.2.i:                                   ; preds = %switch.end.1.1.i, %switch.end.1727.i
  %.1258.2.i = load double, ptr %scevgep3.i7, align 8, !noalias !35
  %.1274.2.i = fmul double %.1071.i, %.1258.2.i
  %.1383.2.i = load double, ptr %scevgep6.i, align 8, !noalias !35
  %.1386.2.i = fmul double %.1258.2.i, %.1383.2.i
  %scevgep39.i = getelementptr i8, ptr %scevgep37.i, i64 %lsr.iv21.i
  %scevgep40.i = getelementptr i8, ptr %scevgep39.i, i64 8
  store double %.1274.2.i, ptr %scevgep40.i, align 8, !noalias !35
  %scevgep32.i10 = getelementptr i8, ptr %scevgep30.i3, i64 %lsr.iv21.i
  %scevgep33.i11 = getelementptr i8, ptr %scevgep32.i10, i64 8
  store double %.1386.2.i, ptr %scevgep33.i11, align 8, !noalias !35
  %.1558.2.i = load double, ptr %lsr.iv.i4, align 8, !noalias !35
  %.1560.2.i = fcmp une double %.1558.2.i, 0.000000e+00
  br i1 %.1560.2.i, label %switch.end.1.2.i, label %B702.2.i

switch.end.1.2.i:                                 ; preds = %switch.end.2.i
  %.1618.2.i = load double, ptr %scevgep39.i, align 8, !noalias !35
  %.1689.2.i = fmul double %.1071.i, %.1558.2.i
  %.1690.2.i = fsub double %.1618.2.i, %.1689.2.i
  store double %.1690.2.i, ptr %scevgep39.i, align 8, !noalias !35
  %.1798.2.i = load double, ptr %scevgep32.i10, align 8, !noalias !35
  %.1853.2.i = load double, ptr %lsr.iv.i4, align 8, !noalias !35
  %.1909.2.i = load double, ptr %scevgep6.i, align 8, !noalias !35
  %.1912.2.i = fmul double %.1853.2.i, %.1909.2.i
  %.1913.2.i = fsub double %.1798.2.i, %.1912.2.i
  store double %.1913.2.i, ptr %scevgep32.i10, align 8, !noalias !35
  br label %B702.2.i

B702.2.i:                                         ; preds = %switch.end.1.2.i, %switch.end.2.i
  %scevgep2.i = getelementptr i8, ptr %lsr.iv.i4, i64 %105
  %lsr.iv.next22.i = add nuw nsw i64 %lsr.iv21.i, 8
  %scevgep5.i12 = getelementptr i8, ptr %lsr.iv2.i, i64 %96
  %exitcond.not.i13 = icmp eq i64 %lsr.iv.next22.i, 40
  br i1 %exitcond.not.i13, label %part.4, label %switch.end.i, !llvm.loop !38

switch.end.i:                                     ; preds = %switch.end.i.preheader, %B702.2.i
  %lsr.iv2.i = phi ptr [ %scevgep5.i12, %B702.2.i ], [ %invariant.gep.2.i, %switch.end.i.preheader ]
  %lsr.iv21.i = phi i64 [ %lsr.iv.next22.i, %B702.2.i ], [ 0, %switch.end.i.preheader ]
  %lsr.iv.i4 = phi ptr [ %scevgep2.i, %B702.2.i ], [ %scevgep26.i, %switch.end.i.preheader ]
  %.456.i = load double, ptr %111, align 8, !noalias !35
  %scevgep11.i5 = getelementptr i8, ptr %lsr.iv2.i, i64 %99
  %scevgep16.i = getelementptr i8, ptr %scevgep11.i5, i64 -16
  %.511.i = load double, ptr %scevgep16.i, align 8, !noalias !35
  %.512.i = fsub double %.456.i, %.511.i
  %.566.i = load double, ptr %.3305.1.i, align 8, !noalias !35
  %scevgep15.i6 = getelementptr i8, ptr %scevgep11.i5, i64 -8
  %.621.i = load double, ptr %scevgep15.i6, align 8, !noalias !35
  %.622.i = fsub double %.566.i, %.621.i
  %.676.i = load double, ptr %.3305.2.i, align 8, !noalias !35
  %.731.i = load double, ptr %scevgep11.i5, align 8, !noalias !35
  %.732.i = fsub double %.676.i, %.731.i
  %scevgep6.i = getelementptr i8, ptr %lsr.iv2.i, i64 %103
  %scevgep9.i = getelementptr i8, ptr %scevgep6.i, i64 -8
  %.787.i = load double, ptr %scevgep9.i, align 8, !noalias !35
  %.788.i = fmul double %.787.i, %.732.i
  %.843.i = load double, ptr %scevgep6.i, align 8, !noalias !35
  %.844.i = fmul double %.622.i, %.843.i
  %.845.i = fsub double %.788.i, %.844.i
  %.901.i = fmul double %.512.i, %.843.i
  %scevgep8.i = getelementptr i8, ptr %scevgep6.i, i64 -16
  %.956.i = load double, ptr %scevgep8.i, align 8, !noalias !35
  %.957.i = fmul double %.732.i, %.956.i
  %.958.i = fsub double %.901.i, %.957.i
  %.1014.i = fmul double %.622.i, %.956.i
  %.1070.i = fmul double %.512.i, %.787.i
  %.1071.i = fsub double %.1014.i, %.1070.i
  %scevgep3.i7 = getelementptr i8, ptr %lsr.iv.i4, i64 -40
  %scevgep35.i = getelementptr i8, ptr %.438, i64 %lsr.iv21.i
  %scevgep36.i = getelementptr i8, ptr %scevgep35.i, i64 8
  %.1258.i = load double, ptr %scevgep3.i7, align 8, !noalias !35
  %.1274.i = fmul double %.1258.i, %.845.i
  %.1386.i = fmul double %.956.i, %.1258.i
  store double %.1274.i, ptr %scevgep36.i, align 8, !noalias !35
  %scevgep24.i = getelementptr i8, ptr %scevgep20.i, i64 %lsr.iv21.i
  %scevgep25.i = getelementptr i8, ptr %scevgep24.i, i64 8
  store double %.1386.i, ptr %scevgep25.i, align 8, !noalias !35
  %.1558.i = load double, ptr %lsr.iv.i4, align 8, !noalias !35
  %.1560.i = fcmp une double %.1558.i, 0.000000e+00
  br i1 %.1560.i, label %switch.end.1.i, label %switch.end.1727.i

switch.end.1.i:                                   ; preds = %switch.end.i
  %.1618.i = load double, ptr %scevgep35.i, align 8, !noalias !35
  %.1689.i = fmul double %.845.i, %.1558.i
  %.1690.i = fsub double %.1618.i, %.1689.i
  store double %.1690.i, ptr %scevgep35.i, align 8, !noalias !35
  %.1798.i = load double, ptr %scevgep24.i, align 8, !noalias !35
  %.1853.i = load double, ptr %lsr.iv.i4, align 8, !noalias !35
  %.1909.i = load double, ptr %scevgep8.i, align 8, !noalias !35
  %.1912.i = fmul double %.1853.i, %.1909.i
  %.1913.i = fsub double %.1798.i, %.1912.i
  store double %.1913.i, ptr %scevgep24.i, align 8, !noalias !35
  br label %switch.end.1727.i

part.4: ; preds = %B702.2.i
  store double 0.000000e+00, ptr %.540, align 8, !noalias !39
  store double 1.000000e+00, ptr %115, align 8, !noalias !39
  store double 2.000000e+00, ptr %116, align 8, !noalias !39
  store double 3.000000e+00, ptr %117, align 8, !noalias !39
  store double 4.000000e+00, ptr %118, align 8, !noalias !39
  store double 5.000000e+00, ptr %119, align 8, !noalias !39
  br label %B84.endif.i

B130.i:                                           ; preds = %B130.prol.loopexit.i, %B130.i
  %lsr.iv12.i21 = phi ptr [ %scevgep13.1.i, %B130.i ], [ %lsr.iv12.unr.i, %B130.prol.loopexit.i ]
  %p.2.1649.i = phi i64 [ %p.3.2.fr.1.i, %B130.i ], [ %p.2.1649.unr.i, %B130.prol.loopexit.i ]
  %.405645647.i = phi i64 [ %10, %B130.i ], [ %.405645647.unr.i, %B130.prol.loopexit.i ]
  %.497.i = load double, ptr %lsr.iv12.i21, align 8, !noalias !39
  %.500.i = tail call double @llvm.fabs.f64(double %.497.i)
  %.529.i = icmp slt i64 %p.2.1649.i, 0
  %.530.i = select i1 %.529.i, i64 %.407, i64 0
  %.531.i = add i64 %.530.i, %p.2.1649.i
  %.551.i = mul i64 %.531.i, %arg.room.5.2
  %gep653.i = getelementptr double, ptr %invariant.gep.i, i64 %.551.i
  %.556.i = load double, ptr %gep653.i, align 8, !noalias !39
  %.559.i = tail call double @llvm.fabs.f64(double %.556.i)
  %.560.i = fcmp ogt double %.500.i, %.559.i
  %p.3.2.i = select i1 %.560.i, i64 %.405645647.i, i64 %p.2.1649.i
  %p.3.2.fr.i = freeze i64 %p.3.2.i
  %scevgep13.i = getelementptr i8, ptr %lsr.iv12.i21, i64 %96
  %.497.1.i = load double, ptr %scevgep13.i, align 8, !noalias !39
  %.500.1.i = tail call double @llvm.fabs.f64(double %.497.1.i)
  %.529.1.i = icmp slt i64 %p.3.2.fr.i, 0
  %.530.1.i = select i1 %.529.1.i, i64 %.407, i64 0
  %.531.1.i = add i64 %.530.1.i, %p.3.2.fr.i
  %.551.1.i = mul i64 %.531.1.i, %arg.room.5.2
  %gep653.1.i = getelementptr double, ptr %invariant.gep.i, i64 %.551.1.i
  %.556.1.i = load double, ptr %gep653.1.i, align 8, !noalias !39
  %.559.1.i = tail call double @llvm.fabs.f64(double %.556.1.i)
  %.560.1.i = fcmp ogt double %.500.1.i, %.559.1.i
  %9 = add i64 %.405645647.i, 1
  %p.3.2.1.i = select i1 %.560.1.i, i64 %9, i64 %p.3.2.fr.i
  %p.3.2.fr.1.i = freeze i64 %p.3.2.1.i
  %scevgep13.1.i = getelementptr i8, ptr %scevgep13.i, i64 %96
  %10 = add i64 %.405645647.i, 2
  %exitcond.not.1.i = icmp eq i64 %10, 6
  br i1 %exitcond.not.1.i, label %B234.i, label %B130.i

B234.i:                                           ; preds = %B130.i, %B130.prol.loopexit.i
  %p.3.2.fr.lcssa.i = phi i64 [ %p.3.2.fr.lcssa.unr.i, %B130.prol.loopexit.i ], [ %p.3.2.fr.1.i, %B130.i ]
  %.606.i = icmp slt i64 %p.3.2.fr.lcssa.i, 0
  %spec.select.i = select i1 %.606.i, i64 %.407, i64 0
  br label %B234.thread.i

B234.thread.i:                                    ; preds = %B84.endif.i, %B234.i
  %p.2.1.lcssa4.i = phi i64 [ 5, %B84.endif.i ], [ %p.3.2.fr.lcssa.i, %B234.i ]
  %11 = phi i64 [ 0, %B84.endif.i ], [ %spec.select.i, %B234.i ]
  %.608.i = add i64 %11, %p.2.1.lcssa4.i
  %.628.i = mul i64 %.608.i, %arg.room.5.2
  %12 = getelementptr double, ptr %.438, i64 %.628.i
  %.632.i = getelementptr double, ptr %12, i64 %.279686707.i
  %.633.i = load double, ptr %.632.i, align 8, !noalias !39
  %.637.i = fcmp oeq double %.633.i, 0.000000e+00
  br i1 %.637.i, label %B262.i, label %B296.i

B262.i:                                           ; preds = %B234.thread.i
  %sunkaddr28.i34 = getelementptr i8, ptr %12, i64 %15
  store double 0x7FF8000000000000, ptr %sunkaddr28.i34, align 8, !noalias !39
  br label %B296.i

B296.i:                                           ; preds = %B262.i, %B234.thread.i
  %.698.not.i = icmp eq i64 %p.2.1.lcssa4.i, %.279686707.i
  br i1 %.698.not.i, label %B452.endif.i, label %B308.endif.endif.i

B84.endif.loopexit.i:                             ; preds = %B584.B490.loopexit_crit_edge.us.loopexit.i, %B492.us.us.us.i
  %scevgep11.i31 = getelementptr i8, ptr %lsr.iv.i17, i64 %120
  %scevgep16.i32 = getelementptr i8, ptr %lsr.iv15.i, i64 %96
  %scevgep24.i33 = getelementptr i8, ptr %lsr.iv23.i, i64 %96
  %scevgep79.i = getelementptr i8, ptr %lsr.iv78.i, i64 %96
  %scevgep85.i = getelementptr i8, ptr %lsr.iv84.i, i64 %96
  br label %B84.endif.i

B84.endif.i:                                      ; preds = %B84.endif.loopexit.i, %part.4
  %lsr.iv84.i = phi ptr [ %scevgep85.i, %B84.endif.loopexit.i ], [ %.438, %part.4 ]
  %lsr.iv78.i = phi ptr [ %scevgep79.i, %B84.endif.loopexit.i ], [ %scevgep41.i, %part.4 ]
  %lsr.iv23.i = phi ptr [ %scevgep24.i33, %B84.endif.loopexit.i ], [ %scevgep22.i16, %part.4 ]
  %lsr.iv15.i = phi ptr [ %scevgep16.i32, %B84.endif.loopexit.i ], [ %scevgep14.i15, %part.4 ]
  %lsr.iv.i17 = phi ptr [ %scevgep11.i31, %B84.endif.loopexit.i ], [ %scevgep41.i, %part.4 ]
  %.279686707.i = phi i64 [ %.286.i, %B84.endif.loopexit.i ], [ 0, %part.4 ]
  %13 = mul i64 %.279686707.i, %96
  %14 = mul i64 %.279686707.i, %120
  %scevgep39.i18 = getelementptr i8, ptr %scevgep41.i, i64 %14
  %15 = shl i64 %.279686707.i, 3
  %scevgep40.i19 = getelementptr i8, ptr %121, i64 %15
  %scevgep41.i20 = getelementptr i8, ptr %.438, i64 %13
  %scevgep45.i = getelementptr i8, ptr %scevgep41.i20, i64 16
  %.286.i = add nuw nsw i64 %.279686707.i, 1
  %.357.not.i = icmp eq i64 %.279686707.i, 5
  br i1 %.357.not.i, label %B234.thread.i, label %B130.lr.ph.i

B130.lr.ph.i:                                     ; preds = %B84.endif.i
  %invariant.gep.i = getelementptr double, ptr %.438, i64 %.279686707.i
  %16 = and i64 %.279686707.i, 1
  %lcmp.mod.not.not.i = icmp eq i64 %16, 0
  br i1 %lcmp.mod.not.not.i, label %B130.prol.i, label %B130.prol.loopexit.i

B130.prol.i:                                      ; preds = %B130.lr.ph.i
  %.412.prol.i = add nuw nsw i64 %.279686707.i, 2
  %.497.prol.i = load double, ptr %lsr.iv.i17, align 8, !noalias !39
  %.500.prol.i = tail call double @llvm.fabs.f64(double %.497.prol.i)
  %.551.prol.i = mul i64 %.279686707.i, %arg.room.5.2
  %gep653.prol.i = getelementptr double, ptr %invariant.gep.i, i64 %.551.prol.i
  %.556.prol.i = load double, ptr %gep653.prol.i, align 8, !noalias !39
  %.559.prol.i = tail call double @llvm.fabs.f64(double %.556.prol.i)
  %.560.prol.i = fcmp ogt double %.500.prol.i, %.559.prol.i
  %p.3.2.prol.i = select i1 %.560.prol.i, i64 %.286.i, i64 %.279686707.i
  %p.3.2.fr.prol.i = freeze i64 %p.3.2.prol.i
  %scevgep13.prol.i = getelementptr i8, ptr %lsr.iv.i17, i64 %96
  br label %B130.prol.loopexit.i

B130.prol.loopexit.i:                             ; preds = %B130.prol.i, %B130.lr.ph.i
  %p.3.2.fr.lcssa.unr.i = phi i64 [ poison, %B130.lr.ph.i ], [ %p.3.2.fr.prol.i, %B130.prol.i ]
  %lsr.iv12.unr.i = phi ptr [ %lsr.iv.i17, %B130.lr.ph.i ], [ %scevgep13.prol.i, %B130.prol.i ]
  %p.2.1649.unr.i = phi i64 [ %.279686707.i, %B130.lr.ph.i ], [ %p.3.2.fr.prol.i, %B130.prol.i ]
  %.405645647.unr.i = phi i64 [ %.286.i, %B130.lr.ph.i ], [ %.412.prol.i, %B130.prol.i ]
  %17 = icmp eq i64 %.279686707.i, 4
  br i1 %17, label %B234.i, label %B130.i

B308.endif.endif.i:                               ; preds = %B296.i
  %18 = icmp slt i64 %p.2.1.lcssa4.i, 0
  %.715.i = select i1 %18, i64 %arg.room.5.2, i64 0
  %19 = getelementptr double, ptr %.540, i64 %p.2.1.lcssa4.i
  %.729.i = getelementptr double, ptr %19, i64 %.715.i
  %.730.i = load double, ptr %.729.i, align 8, !noalias !39
  %20 = getelementptr double, ptr %.540, i64 %.279686707.i
  %.761.i = load double, ptr %20, align 8, !noalias !39
  store double %.730.i, ptr %20, align 8, !noalias !39
  store double %.761.i, ptr %.729.i, align 8, !noalias !39
  %.1043.i = mul i64 %.279686707.i, %arg.room.5.2
  %21 = getelementptr double, ptr %.438, i64 %.1043.i
  %.993.i = load double, ptr %12, align 8, !noalias !39
  %.1048.i = load double, ptr %21, align 8, !noalias !39
  store double %.993.i, ptr %21, align 8, !noalias !39
  store double %.1048.i, ptr %12, align 8, !noalias !39
  %.992.1.i = getelementptr i8, ptr %12, i64 8
  %.993.1.i = load double, ptr %.992.1.i, align 8, !noalias !39
  %.1047.1.i = getelementptr i8, ptr %21, i64 8
  %.1048.1.i = load double, ptr %.1047.1.i, align 8, !noalias !39
  store double %.993.1.i, ptr %.1047.1.i, align 8, !noalias !39
  store double %.1048.1.i, ptr %.992.1.i, align 8, !noalias !39
  %.992.2.i = getelementptr i8, ptr %12, i64 16
  %.993.2.i = load double, ptr %.992.2.i, align 8, !noalias !39
  %.1047.2.i = getelementptr i8, ptr %21, i64 16
  %.1048.2.i = load double, ptr %.1047.2.i, align 8, !noalias !39
  store double %.993.2.i, ptr %.1047.2.i, align 8, !noalias !39
  store double %.1048.2.i, ptr %.992.2.i, align 8, !noalias !39
  %.992.3.i = getelementptr i8, ptr %12, i64 24
  %.993.3.i = load double, ptr %.992.3.i, align 8, !noalias !39
  %.1047.3.i = getelementptr i8, ptr %21, i64 24
  %.1048.3.i = load double, ptr %.1047.3.i, align 8, !noalias !39
  store double %.993.3.i, ptr %.1047.3.i, align 8, !noalias !39
  store double %.1048.3.i, ptr %.992.3.i, align 8, !noalias !39
  %.992.4.i = getelementptr i8, ptr %12, i64 32
  %.993.4.i = load double, ptr %.992.4.i, align 8, !noalias !39
  %.1047.4.i = getelementptr i8, ptr %21, i64 32
  %.1048.4.i = load double, ptr %.1047.4.i, align 8, !noalias !39
  store double %.993.4.i, ptr %.1047.4.i, align 8, !noalias !39
  store double %.1048.4.i, ptr %.992.4.i, align 8, !noalias !39
  %.992.5.i = getelementptr i8, ptr %12, i64 40
  %.993.5.i = load double, ptr %.992.5.i, align 8, !noalias !39
  %.1047.5.i = getelementptr i8, ptr %21, i64 40
  %.1048.5.i = load double, ptr %.1047.5.i, align 8, !noalias !39
  store double %.993.5.i, ptr %.1047.5.i, align 8, !noalias !39
  store double %.1048.5.i, ptr %.992.5.i, align 8, !noalias !39
  br label %B452.endif.i

B452.endif.i:                                     ; preds = %B308.endif.endif.i, %B296.i
  %invariant.gep665.i = getelementptr double, ptr %.438, i64 %.279686707.i
  br i1 %.357.not.i, label %part.5, label %B492.us.preheader.i

B492.us.preheader.i:                              ; preds = %B452.endif.i
  %.1392.i = mul i64 %.279686707.i, %arg.room.5.2
  %22 = getelementptr double, ptr %.438, i64 %.1392.i
  %.1548.us.prol.i = add nuw nsw i64 %.279686707.i, 2
  %invariant.gep5.i = getelementptr double, ptr %.438, i64 %.286.i
  %23 = icmp eq i64 %.279686707.i, 4
  br i1 %23, label %B492.us.us.us.i, label %B492.us.preheader77.i

B492.us.preheader77.i:                            ; preds = %B492.us.preheader.i
  %24 = getelementptr i8, ptr %scevgep41.i, i64 %13
  %25 = getelementptr i8, ptr %122, i64 %13
  %26 = and i64 %.279686707.i, 1
  %27 = icmp eq i64 %26, 0
  %sunkaddr102.i = shl i64 %.1392.i, 3
  %sunkaddr103.i = getelementptr i8, ptr %invariant.gep665.i, i64 %sunkaddr102.i
  %sunkaddr104.i = shl i64 %.286.i, 3
  %sunkaddr105.i = getelementptr i8, ptr %22, i64 %sunkaddr104.i
  br label %B492.us.i

B492.us.us.us.i:                                  ; preds = %B492.us.preheader.i
  %gep666.us.us.us.i = getelementptr double, ptr %invariant.gep665.i, i64 %.1496.2.i
  %.1343.us.us.us.i = load double, ptr %gep666.us.us.us.i, align 8, !noalias !39
  %sunkaddr98.i = shl i64 %.1392.i, 3
  %sunkaddr99.i = getelementptr i8, ptr %invariant.gep665.i, i64 %sunkaddr98.i
  %.1397.us.us.us.i = load double, ptr %sunkaddr99.i, align 8, !noalias !39
  %.1403.us.us.us.i = fdiv double %.1343.us.us.us.i, %.1397.us.us.us.i
  store double %.1403.us.us.us.i, ptr %gep666.us.us.us.i, align 8, !noalias !39
  %gep.us.us.i = getelementptr double, ptr %invariant.gep5.i, i64 %.1496.2.i
  %.1625.us.prol.us.us.i = load double, ptr %gep.us.us.i, align 8, !noalias !39
  %sunkaddr101.i = getelementptr i8, ptr %22, i64 40
  %.1734.us.prol.us.us.i = load double, ptr %sunkaddr101.i, align 8, !noalias !39
  %.1737.us.prol.us.us.i = fmul double %.1403.us.us.us.i, %.1734.us.prol.us.us.i
  %.1738.us.prol.us.us.i = fsub double %.1625.us.prol.us.us.i, %.1737.us.prol.us.us.i
  store double %.1738.us.prol.us.us.i, ptr %gep.us.us.i, align 8, !noalias !39
  br label %B84.endif.loopexit.i

B492.us.i:                                        ; preds = %B584.B490.loopexit_crit_edge.us.loopexit.i, %B492.us.preheader77.i
  %lsr.iv80.i = phi ptr [ %lsr.iv78.i, %B492.us.preheader77.i ], [ %scevgep81.i, %B584.B490.loopexit_crit_edge.us.loopexit.i ]
  %indvar.i = phi i64 [ 0, %B492.us.preheader77.i ], [ %indvar.next.i, %B584.B490.loopexit_crit_edge.us.loopexit.i ]
  %lsr.iv17.i = phi ptr [ %lsr.iv15.i, %B492.us.preheader77.i ], [ %scevgep18.i, %B584.B490.loopexit_crit_edge.us.loopexit.i ]
  %.1255670676.us.i = phi i64 [ %.286.i, %B492.us.preheader77.i ], [ %.1262.us.i, %B584.B490.loopexit_crit_edge.us.loopexit.i ]
  %28 = mul i64 %indvar.i, %96
  %scevgep33.i22 = getelementptr i8, ptr %24, i64 %28
  %scevgep37.i23 = getelementptr i8, ptr %25, i64 %28
  %.1338.us.i = mul i64 %.1255670676.us.i, %arg.room.5.2
  %gep666.us.i = getelementptr double, ptr %invariant.gep665.i, i64 %.1338.us.i
  %.1343.us.i = load double, ptr %gep666.us.i, align 8, !noalias !39
  %.1397.us.i = load double, ptr %sunkaddr103.i, align 8, !noalias !39
  %.1403.us.i = fdiv double %.1343.us.i, %.1397.us.i
  store double %.1403.us.i, ptr %gep666.us.i, align 8, !noalias !39
  br i1 %27, label %B586.us.prol.i, label %B492.us.B586.us.prol.loopexit_crit_edge.i

B492.us.B586.us.prol.loopexit_crit_edge.i:        ; preds = %B492.us.i
  %.pre.i24 = shl i64 %.1338.us.i, 3
  br label %B586.us.prol.loopexit.i

B586.us.prol.i:                                   ; preds = %B492.us.i
  %gep.i = getelementptr double, ptr %invariant.gep5.i, i64 %.1338.us.i
  %.1625.us.prol.i = load double, ptr %gep.i, align 8, !noalias !39
  %sunkaddr31.i = shl i64 %.1338.us.i, 3
  %sunkaddr32.i = getelementptr i8, ptr %invariant.gep665.i, i64 %sunkaddr31.i
  %.1679.us.prol.i = load double, ptr %sunkaddr32.i, align 8, !noalias !39
  %.1734.us.prol.i = load double, ptr %sunkaddr105.i, align 8, !noalias !39
  %.1737.us.prol.i = fmul double %.1679.us.prol.i, %.1734.us.prol.i
  %.1738.us.prol.i = fsub double %.1625.us.prol.i, %.1737.us.prol.i
  store double %.1738.us.prol.i, ptr %gep.i, align 8, !noalias !39
  br label %B586.us.prol.loopexit.i

B586.us.prol.loopexit.i:                          ; preds = %B586.us.prol.i, %B492.us.B586.us.prol.loopexit_crit_edge.i
  %sunkaddr35.pre-phi.i = phi i64 [ %.pre.i24, %B492.us.B586.us.prol.loopexit_crit_edge.i ], [ %sunkaddr31.i, %B586.us.prol.i ]
  %.1541659661.us.unr.i = phi i64 [ %.286.i, %B492.us.B586.us.prol.loopexit_crit_edge.i ], [ %.1548.us.prol.i, %B586.us.prol.i ]
  %29 = sub i64 4, %.1541659661.us.unr.i
  %30 = lshr i64 %29, 1
  %31 = add nuw i64 %30, 1
  %min.iters.check.i = icmp ult i64 %29, 66
  br i1 %min.iters.check.i, label %B586.us.preheader.i, label %vector.scevcheck.i

vector.scevcheck.i:                               ; preds = %B586.us.prol.loopexit.i
  %32 = shl nuw nsw i64 %.1541659661.us.unr.i, 3
  %scevgep15.i25 = getelementptr i8, ptr %scevgep33.i22, i64 %32
  %mul.result.i = shl i64 %30, 4
  %33 = getelementptr i8, ptr %scevgep15.i25, i64 %mul.result.i
  %34 = icmp ult ptr %33, %scevgep15.i25
  %scevgep17.i = getelementptr i8, ptr %lsr.iv17.i, i64 %32
  %mul.overflow20.i = icmp ugt i64 %29, 2305843009213693951
  %35 = getelementptr i8, ptr %scevgep17.i, i64 %mul.result.i
  %36 = icmp ult ptr %35, %scevgep17.i
  %37 = or i1 %mul.overflow20.i, %36
  %scevgep25.i26 = getelementptr i8, ptr %scevgep41.i20, i64 %32
  %38 = getelementptr i8, ptr %scevgep25.i26, i64 %mul.result.i
  %39 = icmp ult ptr %38, %scevgep25.i26
  %scevgep29.i27 = getelementptr i8, ptr %lsr.iv23.i, i64 %32
  %40 = getelementptr i8, ptr %scevgep29.i27, i64 %mul.result.i
  %41 = icmp ult ptr %40, %scevgep29.i27
  %42 = or i1 %34, %37
  %43 = or i1 %39, %42
  %44 = or i1 %41, %43
  br i1 %44, label %B586.us.preheader.i, label %vector.memcheck.i

vector.memcheck.i:                                ; preds = %vector.scevcheck.i
  %45 = sub nsw i64 32, %32
  %46 = and i64 %45, -16
  %47 = add i64 %46, %32
  %scevgep35.i28 = getelementptr i8, ptr %lsr.iv17.i, i64 %47
  %scevgep38.i = getelementptr i8, ptr %scevgep37.i23, i64 %47
  %scevgep43.i29 = getelementptr i8, ptr %lsr.iv23.i, i64 %47
  %scevgep46.i = getelementptr i8, ptr %scevgep45.i, i64 %47
  %bound0.i = icmp ult ptr %scevgep15.i25, %scevgep38.i
  %bound1.i = icmp ult ptr %scevgep17.i, %scevgep35.i28
  %found.conflict.i = and i1 %bound0.i, %bound1.i
  %bound047.i = icmp ult ptr %scevgep15.i25, %scevgep40.i19
  %bound148.i = icmp ult ptr %scevgep39.i18, %scevgep35.i28
  %found.conflict49.i = and i1 %bound047.i, %bound148.i
  %48 = or i1 %123, %found.conflict49.i
  %conflict.rdx.i = or i1 %found.conflict.i, %48
  %bound050.i = icmp ult ptr %scevgep15.i25, %scevgep43.i29
  %bound151.i = icmp ult ptr %scevgep25.i26, %scevgep35.i28
  %found.conflict52.i = and i1 %bound050.i, %bound151.i
  %conflict.rdx53.i = or i1 %found.conflict52.i, %conflict.rdx.i
  %bound054.i = icmp ult ptr %scevgep15.i25, %scevgep46.i
  %bound155.i = icmp ult ptr %scevgep29.i27, %scevgep35.i28
  %found.conflict56.i = and i1 %bound054.i, %bound155.i
  %conflict.rdx57.i = or i1 %found.conflict56.i, %conflict.rdx53.i
  %bound058.i = icmp ult ptr %scevgep17.i, %scevgep40.i19
  %bound159.i = icmp ult ptr %scevgep39.i18, %scevgep38.i
  %found.conflict60.i = and i1 %bound058.i, %bound159.i
  %conflict.rdx62.i = or i1 %found.conflict60.i, %conflict.rdx57.i
  %bound063.i = icmp ult ptr %scevgep17.i, %scevgep43.i29
  %bound164.i = icmp ult ptr %scevgep25.i26, %scevgep38.i
  %found.conflict65.i = and i1 %bound063.i, %bound164.i
  %conflict.rdx66.i = or i1 %found.conflict65.i, %conflict.rdx62.i
  %bound067.i = icmp ult ptr %scevgep17.i, %scevgep46.i
  %bound168.i = icmp ult ptr %scevgep29.i27, %scevgep38.i
  %found.conflict69.i = and i1 %bound067.i, %bound168.i
  %conflict.rdx70.i = or i1 %found.conflict69.i, %conflict.rdx66.i
  br i1 %conflict.rdx70.i, label %B586.us.preheader.i, label %vector.ph.i

vector.ph.i:                                      ; preds = %vector.memcheck.i
  %n.vec.i = and i64 %31, -2
  %sunkaddr106.i = getelementptr i8, ptr %invariant.gep665.i, i64 %sunkaddr35.pre-phi.i
  br label %vector.body.i

vector.body.i:                                    ; preds = %vector.body.i, %vector.ph.i
  %lsr.iv87.i = phi i64 [ %lsr.iv.next88.i, %vector.body.i ], [ %n.vec.i, %vector.ph.i ]
  %lsr.iv82.i = phi i64 [ %lsr.iv.next.i30, %vector.body.i ], [ %32, %vector.ph.i ]
  %scevgep83.i = getelementptr i8, ptr %lsr.iv80.i, i64 %lsr.iv82.i
  %wide.vec.i = load <4 x double>, ptr %scevgep83.i, align 8, !noalias !39
  %49 = load double, ptr %sunkaddr106.i, align 8, !alias.scope !42, !noalias !39
  %broadcast.splatinsert.i = insertelement <2 x double> poison, double %49, i64 0
  %scevgep86.i = getelementptr i8, ptr %lsr.iv84.i, i64 %lsr.iv82.i
  %wide.vec72.i = load <4 x double>, ptr %scevgep86.i, align 8, !noalias !39
  %50 = shufflevector <2 x double> %broadcast.splatinsert.i, <2 x double> poison, <4 x i32> zeroinitializer
  %51 = fmul <4 x double> %50, %wide.vec72.i
  %interleaved.vec.i = fsub <4 x double> %wide.vec.i, %51
  store <4 x double> %interleaved.vec.i, ptr %scevgep83.i, align 8, !noalias !39
  %lsr.iv.next.i30 = add i64 %lsr.iv82.i, 32
  %lsr.iv.next88.i = add i64 %lsr.iv87.i, -2
  %52 = icmp eq i64 %lsr.iv.next88.i, 0
  br i1 %52, label %middle.block.i, label %vector.body.i, !llvm.loop !45

middle.block.i:                                   ; preds = %vector.body.i
  %53 = shl i64 %n.vec.i, 1
  %54 = add i64 %53, %.1541659661.us.unr.i
  %cmp.n.i = icmp eq i64 %31, %n.vec.i
  br i1 %cmp.n.i, label %B584.B490.loopexit_crit_edge.us.loopexit.i, label %B586.us.preheader.i

B586.us.preheader.i:                              ; preds = %middle.block.i, %vector.memcheck.i, %vector.scevcheck.i, %B586.us.prol.loopexit.i
  %.1541659661.us.ph.i = phi i64 [ %.1541659661.us.unr.i, %vector.memcheck.i ], [ %.1541659661.us.unr.i, %vector.scevcheck.i ], [ %.1541659661.us.unr.i, %B586.us.prol.loopexit.i ], [ %54, %middle.block.i ]
  %55 = add i64 %.1541659661.us.ph.i, 1
  %sunkaddr107.i = getelementptr i8, ptr %invariant.gep665.i, i64 %sunkaddr35.pre-phi.i
  br label %B586.us.i

B586.us.i:                                        ; preds = %B586.us.i, %B586.us.preheader.i
  %lsr.iv89.i = phi i64 [ %55, %B586.us.preheader.i ], [ %lsr.iv.next90.i, %B586.us.i ]
  %56 = shl i64 %lsr.iv89.i, 3
  %scevgep91.i = getelementptr i8, ptr %lsr.iv80.i, i64 %56
  %scevgep92.i = getelementptr i8, ptr %scevgep91.i, i64 -8
  %.1625.us.i = load double, ptr %scevgep92.i, align 8, !noalias !39
  %.1679.us.i = load double, ptr %sunkaddr107.i, align 8, !noalias !39
  %scevgep95.i = getelementptr i8, ptr %lsr.iv84.i, i64 %56
  %scevgep94.i = getelementptr i8, ptr %scevgep95.i, i64 -8
  %.1734.us.i = load double, ptr %scevgep94.i, align 8, !noalias !39
  %.1737.us.i = fmul double %.1679.us.i, %.1734.us.i
  %.1738.us.i = fsub double %.1625.us.i, %.1737.us.i
  store double %.1738.us.i, ptr %scevgep92.i, align 8, !noalias !39
  %.1625.us.1.i = load double, ptr %scevgep91.i, align 8, !noalias !39
  %.1679.us.1.i = load double, ptr %sunkaddr107.i, align 8, !noalias !39
  %.1734.us.1.i = load double, ptr %scevgep95.i, align 8, !noalias !39
  %.1737.us.1.i = fmul double %.1679.us.1.i, %.1734.us.1.i
  %.1738.us.1.i = fsub double %.1625.us.1.i, %.1737.us.1.i
  store double %.1738.us.1.i, ptr %scevgep91.i, align 8, !noalias !39
  %lsr.iv.next90.i = add i64 %lsr.iv89.i, 2
  %exitcond721.not.1.i = icmp eq i64 %lsr.iv.next90.i, 7
  br i1 %exitcond721.not.1.i, label %B584.B490.loopexit_crit_edge.us.loopexit.i, label %B586.us.i, !llvm.loop !46

B584.B490.loopexit_crit_edge.us.loopexit.i:       ; preds = %B586.us.i, %middle.block.i
  %.1262.us.i = add nuw nsw i64 %.1255670676.us.i, 1
  %scevgep18.i = getelementptr i8, ptr %lsr.iv17.i, i64 %96
  %indvar.next.i = add i64 %indvar.i, 1
  %scevgep81.i = getelementptr i8, ptr %lsr.iv80.i, i64 %96
  %exitcond722.not.i = icmp eq i64 %.1262.us.i, 6
  br i1 %exitcond722.not.i, label %B84.endif.loopexit.i, label %B492.us.i

part.5: ; preds = %B452.endif.i
  br i1 %124, label %B336.lr.ph, label %B402.endif.endif

B336:                                             ; preds = %B336.preheader99, %B336
  %lsr.iv139 = phi ptr [ %lsr.iv137, %B336.preheader99 ], [ %scevgep140, %B336 ]
  %lsr.iv134 = phi ptr [ %lsr.iv132, %B336.preheader99 ], [ %scevgep135, %B336 ]
  %lsr.iv131 = phi i64 [ 0, %B336.preheader99 ], [ %lsr.iv.next, %B336 ]
  %scevgep141 = getelementptr i8, ptr %lsr.iv139, i64 %168
  %.1553 = load double, ptr %scevgep141, align 8
  %scevgep136 = getelementptr i8, ptr %lsr.iv134, i64 %167
  %.1608 = load double, ptr %scevgep136, align 8
  %57 = shl i64 %lsr.iv131, 3
  %scevgep156 = getelementptr i8, ptr %scevgep154, i64 %57
  %scevgep157 = getelementptr i8, ptr %scevgep156, i64 -8
  store double %.1553, ptr %scevgep157, align 8
  %scevgep149 = getelementptr i8, ptr %scevgep147, i64 %57
  %scevgep150 = getelementptr i8, ptr %scevgep149, i64 -8
  store double %.1608, ptr %scevgep150, align 8
  %scevgep142 = getelementptr i8, ptr %lsr.iv139, i64 %170
  %.1553.1 = load double, ptr %scevgep142, align 8
  %scevgep143 = getelementptr i8, ptr %lsr.iv134, i64 %171
  %.1608.1 = load double, ptr %scevgep143, align 8
  store double %.1553.1, ptr %scevgep156, align 8
  store double %.1608.1, ptr %scevgep149, align 8
  %lsr.iv.next = add i64 %lsr.iv131, 2
  %scevgep135 = getelementptr i8, ptr %lsr.iv134, i64 %91
  %scevgep140 = getelementptr i8, ptr %lsr.iv139, i64 %92
  %exitcond.not.1 = icmp eq i64 %166, %lsr.iv.next
  br i1 %exitcond.not.1, label %B402.endif.endif, label %B336, !llvm.loop !47

B470.2:                                           ; preds = %B402.endif.endif
  %.1942 = load double, ptr %arg.ride.4, align 8
  %.1997 = load double, ptr %scevgep, align 8
  %.1998 = fmul double %.1942, %.1997
  %.2008 = fsub double %.1899, %.1998
  store double %.2008, ptr %.849, align 8
  %.1897.1 = getelementptr i8, ptr %173, i64 %arg.twist.6.1
  %.1899.1 = load double, ptr %.1897.1, align 8
  %.1942.1 = load double, ptr %.764.1.i, align 8
  %.1997.1 = load double, ptr %scevgep, align 8
  %.1998.1 = fmul double %.1942.1, %.1997.1
  %.2008.1 = fsub double %.1899.1, %.1998.1
  store double %.2008.1, ptr %sunkaddr175, align 8
  %.1942.2 = load double, ptr %.764.2.i, align 8
  %.1997.2 = load double, ptr %scevgep, align 8
  %.1998.2 = fmul double %.1942.2, %.1997.2
  br label %B510.5

B510.5:                                           ; preds = %B510.1.thread, %B470.2
  %"$phi510.3.2.2.2" = phi double [ %.1998.2, %B470.2 ], [ 0.000000e+00, %B510.1.thread ]
  %sunkaddr162 = getelementptr i8, ptr %173, i64 %sunkaddr161
  %.1899.21270 = load double, ptr %sunkaddr162, align 8
  %.2008.2 = fsub double %.1899.21270, %"$phi510.3.2.2.2"
  store double %.2008.2, ptr %sunkaddr163, align 8
  %.1897.3 = getelementptr i8, ptr %173, i64 %.1894.3
  %.1899.3 = load double, ptr %.1897.3, align 8
  store double %.1899.3, ptr %sunkaddr164, align 8
  %sunkaddr166 = getelementptr i8, ptr %173, i64 %sunkaddr165
  %.1899.4 = load double, ptr %sunkaddr166, align 8
  store double %.1899.4, ptr %sunkaddr167, align 8
  %.1897.5 = getelementptr i8, ptr %173, i64 %.1894.5
  %.1899.5 = load double, ptr %.1897.5, align 8
  store double %.1899.5, ptr %sunkaddr168, align 8
  br i1 %125, label %B524.else.if, label %B524.else.endif, !prof !30

B844:                                             ; preds = %B784.endif, %B0.endif.else.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B0.else.endif.endif.endif:                        ; preds = %B0.else.endif
  %.347 = icmp samesign ult i64 %arg.room.5.1, 7
  br i1 %.347, label %B0.else.endif.endif.endif.if, label %B0.endif.else.endif, !prof !48

B0.else.endif.endif.endif.if:                     ; preds = %B0.else.endif.endif.endif
  br label %B0.endif.else.endif

B0.endif.else.endif:                              ; preds = %B0.else.endif.endif.endif.if, %B0.else.endif.endif.endif, %B0.else.endif
  %.310.sroa.0.31273 = phi i64 [ 0, %B0.else.endif.endif.endif ], [ 0, %B0.else.endif.endif.endif.if ], [ %arg.room.5.1, %B0.else.endif ]
  %.310.sroa.13.0 = phi i64 [ 6, %B0.else.endif.endif.endif ], [ %arg.room.5.1, %B0.else.endif.endif.endif.if ], [ %arg.room.5.1, %B0.else.endif ]
  %.398 = sub i64 %.310.sroa.13.0, %.310.sroa.0.31273
  %.407 = tail call i64 @llvm.smax.i64(i64 %.398, i64 0)
  %.432 = mul i64 %arg.room.5.2, 3
  %.434 = mul i64 %.432, %arg.room.5.1
  %.436 = mul i64 %.310.sroa.0.31273, %arg.room.5.2
  %58 = getelementptr double, ptr %arg.room.4, i64 %.434
  %.438 = getelementptr double, ptr %58, i64 %.436
  %.540.idx = mul i64 %arg.room.5.2, 48
  %.540 = getelementptr i8, ptr %58, i64 %.540.idx
  %.619.sroa.0.31277 = tail call i64 @llvm.smin.i64(i64 %arg.room.5.1, i64 3)
  %.745 = mul i64 %.619.sroa.0.31277, %arg.room.5.2
  %.747 = getelementptr double, ptr %arg.room.4, i64 %.745
  %.849.idx = mul i64 %arg.room.5.2, 40
  %.849 = getelementptr i8, ptr %arg.room.4, i64 %.849.idx
  %.11401147.not = icmp slt i64 %arg.q.5.0, 1
  br i1 %.11401147.not, label %B844, label %B182.lr.ph

B182.lr.ph:                                       ; preds = %B0.endif.else.endif
  %.1421 = icmp slt i64 %arg.q.5.1, 7
  %..259 = select i1 %.1421, i64 0, i64 %.259
  %.2102 = icmp slt i64 %arg.q.5.1, 6
  %.2103 = select i1 %.2102, i64 %arg.qd.5.1, i64 0
  %.2104 = add i64 %.2103, %.259
  %.2979 = select i1 %.2102, i64 %arg.qdd.5.1, i64 0
  %.2980 = add i64 %.2979, %.259
  %.1894.3 = mul i64 %arg.twist.6.1, 3
  %.1894.5 = mul i64 %arg.twist.6.1, 5
  %.2432.1 = icmp slt i64 %arg.q.5.1, 5
  %.2433.1 = select i1 %.2432.1, i64 %arg.qdd.5.1, i64 0
  %.2432.2 = icmp slt i64 %arg.q.5.1, 4
  %.2433.2 = select i1 %.2432.2, i64 %arg.qdd.5.1, i64 0
  %.2432.3 = icmp slt i64 %arg.q.5.1, 3
  %.2433.3 = select i1 %.2432.3, i64 %arg.qdd.5.1, i64 0
  %.2432.4 = icmp slt i64 %arg.q.5.1, 2
  %.2433.4 = select i1 %.2432.4, i64 %arg.qdd.5.1, i64 0
  %.2432.5.inv = icmp sgt i64 %arg.q.5.1, 0
  %.2433.5 = select i1 %.2432.5.inv, i64 0, i64 %arg.qdd.5.1
  %.2827.3 = mul i64 %arg.bend.6.1, 3
  %.2827.5 = mul i64 %arg.bend.6.1, 5
  %59 = add i64 %..259, -1
  %60 = add nsw i64 %arg.q.5.0, -1
  %61 = mul i64 %arg.qd.5.1, %60
  %62 = add i64 %61, %..259
  %63 = shl i64 %62, 3
  %scevgep71 = getelementptr i8, ptr %arg.qd.4, i64 %63
  %64 = shl i64 %arg.qd.5.1, 3
  %65 = mul i64 %arg.qdd.5.1, %60
  %66 = add i64 %65, %..259
  %67 = shl i64 %66, 3
  %scevgep72 = getelementptr i8, ptr %arg.qdd.4, i64 %67
  %68 = shl i64 %arg.qdd.5.1, 3
  %69 = mul i64 %arg.rail_rate.6.0, %60
  %70 = getelementptr i8, ptr %arg.rail_rate.4, i64 %..259
  %71 = getelementptr i8, ptr %70, i64 %69
  %scevgep73 = getelementptr i8, ptr %71, i64 7
  %72 = mul i64 %arg.rail_bend.6.0, %60
  %73 = getelementptr i8, ptr %arg.rail_bend.4, i64 %..259
  %74 = getelementptr i8, ptr %73, i64 %72
  %scevgep74 = getelementptr i8, ptr %74, i64 7
  %ident.check = icmp ne i64 %arg.rail_rate.6.1, 1
  %ident.check68 = icmp ne i64 %arg.rail_bend.6.1, 1
  %75 = or i1 %ident.check, %ident.check68
  %bound0 = icmp ult ptr %arg.qd.4, %scevgep72
  %bound1 = icmp ult ptr %arg.qdd.4, %scevgep71
  %found.conflict = and i1 %bound1, %bound0
  %76 = or i64 %68, %64
  %77 = icmp slt i64 %76, 0
  %78 = or i1 %77, %found.conflict
  %bound076 = icmp ult ptr %arg.qd.4, %scevgep73
  %bound177 = icmp ult ptr %arg.rail_rate.4, %scevgep71
  %found.conflict78 = and i1 %bound076, %bound177
  %79 = or i64 %64, %arg.rail_rate.6.0
  %80 = icmp slt i64 %79, 0
  %81 = or i1 %80, %found.conflict78
  %conflict.rdx = or i1 %81, %78
  %bound081 = icmp ult ptr %arg.qd.4, %scevgep74
  %bound182 = icmp ult ptr %arg.rail_bend.4, %scevgep71
  %found.conflict83 = and i1 %bound081, %bound182
  %82 = or i64 %64, %arg.rail_bend.6.0
  %83 = icmp slt i64 %82, 0
  %84 = or i1 %83, %found.conflict83
  %conflict.rdx86 = or i1 %84, %conflict.rdx
  %bound087 = icmp ult ptr %arg.qdd.4, %scevgep73
  %bound188 = icmp ult ptr %arg.rail_rate.4, %scevgep72
  %found.conflict89 = and i1 %bound087, %bound188
  %85 = or i64 %68, %arg.rail_rate.6.0
  %86 = icmp slt i64 %85, 0
  %87 = or i1 %86, %found.conflict89
  %conflict.rdx92 = or i1 %87, %conflict.rdx86
  %bound093 = icmp ult ptr %arg.qdd.4, %scevgep74
  %bound194 = icmp ult ptr %arg.rail_bend.4, %scevgep72
  %found.conflict95 = and i1 %bound093, %bound194
  %88 = or i64 %68, %arg.rail_bend.6.0
  %89 = icmp slt i64 %88, 0
  %90 = or i1 %89, %found.conflict95
  %conflict.rdx98 = or i1 %90, %conflict.rdx92
  %n.vec = and i64 %..259, 9223372036854775804
  %scevgep100 = getelementptr i8, ptr %arg.rail_rate.4, i64 3
  %scevgep109 = getelementptr i8, ptr %arg.rail_bend.4, i64 3
  %scevgep119 = getelementptr i8, ptr %arg.qd.4, i64 16
  %scevgep125 = getelementptr i8, ptr %arg.qdd.4, i64 16
  %91 = shl i64 %arg.rail_bend.6.1, 1
  %92 = shl i64 %arg.rail_rate.6.1, 1
  %scevgep144 = getelementptr i8, ptr %arg.qdd.4, i64 8
  %scevgep151 = getelementptr i8, ptr %arg.qd.4, i64 8
  %.162.i = mul i64 %arg.room.5.2, %arg.room.5.1
  %.342.idx.i = shl i64 %.162.i, 4
  %.342.i = getelementptr i8, ptr %arg.room.4, i64 %.342.idx.i
  %.616.i = mul i64 %arg.X_WO.6.1, 3
  %invariant.gep1129.i = getelementptr i8, ptr %arg.X_WO.4, i64 %.616.i
  %.678.not.i = icmp eq i64 %.259, 0
  %invariant.gep.2.i = getelementptr i8, ptr %arg.room.4, i64 16
  %gep.1.2.i = getelementptr double, ptr %invariant.gep.2.i, i64 %arg.room.5.2
  %93 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  %.idx1123.i = shl i64 %arg.room.5.2, 4
  %94 = getelementptr i8, ptr %arg.room.4, i64 %.idx1123.i
  %.1904.1.i = getelementptr i8, ptr %arg.room.4, i64 8
  %.2015.1.i = getelementptr i8, ptr %93, i64 8
  %.2126.1.i = getelementptr i8, ptr %94, i64 8
  %.2015.2.i = getelementptr i8, ptr %93, i64 16
  %.2126.2.i = getelementptr i8, ptr %94, i64 16
  %.1281.peel.i = getelementptr i8, ptr %arg.chain.4, i64 8
  %.1300.peel.i = select i1 %.2102, i64 %arg.q.5.1, i64 0
  %.1301.peel.i = add i64 %.1300.peel.i, %.259
  %.1312.peel.i = mul i64 %.1301.peel.i, %arg.q.6.1
  %.1371.peel.i = getelementptr i8, ptr %arg.chain.4, i64 16
  %.1427.peel.i = getelementptr i8, ptr %arg.chain.4, i64 48
  %.1959.peel.i = getelementptr i8, ptr %arg.chain.4, i64 24
  %.2070.peel.i = getelementptr i8, ptr %arg.chain.4, i64 32
  %.2181.peel.i = getelementptr i8, ptr %arg.chain.4, i64 40
  %sunkaddr54.i = shl i64 %.162.i, 3
  %sunkaddr55.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr54.i
  %sunkaddr24.i = getelementptr i8, ptr %.342.i, i64 8
  %sunkaddr60.i = getelementptr i8, ptr %sunkaddr55.i, i64 8
  %sunkaddr26.i = getelementptr i8, ptr %.342.i, i64 16
  %sunkaddr65.i = getelementptr i8, ptr %sunkaddr55.i, i64 16
  %95 = add i64 %.342.idx.i, 16
  %96 = shl i64 %arg.room.5.2, 3
  %97 = shl i64 %arg.room.5.1, 4
  %98 = or disjoint i64 %97, 8
  %99 = mul i64 %98, %arg.room.5.2
  %100 = add i64 %99, 16
  %101 = shl i64 %arg.room.5.1, 3
  %102 = add i64 %101, 8
  %103 = mul i64 %102, %arg.room.5.2
  %104 = add i64 %103, 16
  %105 = shl i64 %arg.chain.5.1, 3
  %106 = getelementptr i8, ptr %arg.chain.4, i64 %105
  %scevgep26.i = getelementptr i8, ptr %106, i64 48
  %107 = add i64 %arg.q.5.1, -5
  %sunkaddr28.i = getelementptr i8, ptr %arg.room.4, i64 %96
  %sunkaddr33.i = getelementptr i8, ptr %sunkaddr28.i, i64 8
  %sunkaddr39.i = getelementptr i8, ptr %sunkaddr28.i, i64 16
  %108 = getelementptr i8, ptr %.342.i, i64 %.849.idx
  %.3025.i = mul i64 %arg.X_6T.6.1, 3
  %.3028.i = getelementptr i8, ptr %arg.X_6T.4, i64 %.3025.i
  %109 = getelementptr i8, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0
  %.3138.i = getelementptr i8, ptr %109, i64 %.3025.i
  %.3244.i = shl i64 %arg.X_6T.6.0, 1
  %110 = getelementptr i8, ptr %arg.X_6T.4, i64 %.3244.i
  %.3248.i = getelementptr i8, ptr %110, i64 %.3025.i
  %111 = getelementptr i8, ptr %.342.i, i64 %.540.idx
  %.2921.1.i = getelementptr i8, ptr %108, i64 8
  %.3305.1.i = getelementptr i8, ptr %111, i64 8
  %.2921.2.i = getelementptr i8, ptr %108, i64 16
  %.3305.2.i = getelementptr i8, ptr %111, i64 16
  %.121.i = getelementptr double, ptr %arg.room.4, i64 %.162.i
  %.1496.1.i = shl i64 %arg.room.5.2, 2
  %.1437.2.i = shl i64 %arg.room.5.2, 1
  %.1496.2.i = mul i64 %arg.room.5.2, 5
  %.786.peel.i = getelementptr i8, ptr %.121.i, i64 8
  %.842.peel.i = getelementptr i8, ptr %.121.i, i64 16
  %112 = getelementptr i8, ptr %.438, i64 -8
  %invariant.gep710.peel.i = getelementptr double, ptr %112, i64 %arg.room.5.2
  %gep709.peel.i = getelementptr double, ptr %.438, i64 %.432
  %gep.1.peel.i = getelementptr double, ptr %.438, i64 %arg.room.5.2
  %gep709.1.peel.i = getelementptr double, ptr %.438, i64 %.1496.1.i
  %gep.2.peel.i = getelementptr double, ptr %.438, i64 %.1437.2.i
  %gep709.2.peel.i = getelementptr double, ptr %.438, i64 %.1496.2.i
  %113 = mul i64 %arg.room.5.2, 24
  %scevgep20.i = getelementptr i8, ptr %.438, i64 %113
  %114 = shl i64 %arg.room.5.2, 5
  %scevgep26.i2 = getelementptr i8, ptr %.438, i64 %114
  %scevgep30.i3 = getelementptr i8, ptr %.438, i64 %.849.idx
  %scevgep37.i = getelementptr i8, ptr %.438, i64 %.idx1123.i
  %scevgep41.i = getelementptr i8, ptr %.438, i64 %96
  %115 = getelementptr i8, ptr %.540, i64 8
  %116 = getelementptr i8, ptr %.540, i64 16
  %117 = getelementptr i8, ptr %.540, i64 24
  %118 = getelementptr i8, ptr %.540, i64 32
  %119 = getelementptr i8, ptr %.540, i64 40
  %120 = add i64 %96, 8
  %scevgep14.i15 = getelementptr i8, ptr %.438, i64 %120
  %scevgep22.i16 = getelementptr i8, ptr %.438, i64 8
  %121 = getelementptr i8, ptr %scevgep30.i3, i64 8
  %122 = getelementptr i8, ptr %scevgep41.i, i64 16
  %123 = icmp slt i64 %96, 0
  %124 = icmp sgt i64 %..259, 0
  %125 = icmp slt i64 %.2104, 0
  %sunkaddr161 = shl i64 %arg.twist.6.1, 1
  %sunkaddr163 = getelementptr i8, ptr %.849, i64 16
  %sunkaddr164 = getelementptr i8, ptr %.849, i64 24
  %sunkaddr165 = shl i64 %arg.twist.6.1, 2
  %sunkaddr167 = getelementptr i8, ptr %.849, i64 32
  %sunkaddr168 = getelementptr i8, ptr %.849, i64 40
  %126 = icmp slt i64 %.2104, %arg.qd.5.1
  %.329.i = add nsw i64 %arg.qd.5.1, -6
  %.456.not.i = icmp eq i64 %.329.i, 0
  %127 = getelementptr double, ptr %.747, i64 %arg.room.5.2
  %sunkaddr27.i = getelementptr i8, ptr %.747, i64 %96
  %sunkaddr28.i35 = getelementptr i8, ptr %sunkaddr27.i, i64 16
  %.771.2.i = getelementptr i8, ptr %.747, i64 40
  %sunkaddr31.i36 = getelementptr i8, ptr %sunkaddr27.i, i64 40
  %arg.out.5.1..i = tail call i64 @llvm.smin.i64(i64 %arg.room.5.2, i64 3)
  %128 = add i64 %64, -48
  %sunkaddr22.i = shl i64 %arg.out.5.1..i, 3
  %sunkaddr23.i = getelementptr i8, ptr %127, i64 %sunkaddr22.i
  %sunkaddr25.i = getelementptr i8, ptr %.747, i64 %sunkaddr22.i
  %sunkaddr26.i39 = getelementptr i8, ptr %sunkaddr25.i, i64 8
  %sunkaddr32.i40 = getelementptr i8, ptr %sunkaddr25.i, i64 16
  %sunkaddr35.i = getelementptr i8, ptr %sunkaddr23.i, i64 8
  %sunkaddr42.i = getelementptr i8, ptr %sunkaddr23.i, i64 16
  %sunkaddr45.i41 = getelementptr i8, ptr %127, i64 8
  %sunkaddr46.i42 = getelementptr i8, ptr %127, i64 16
  %sunkaddr47.i = getelementptr i8, ptr %.747, i64 8
  %sunkaddr48.i = getelementptr i8, ptr %.747, i64 16
  %129 = icmp slt i64 %.2980, 0
  %sunkaddr174 = getelementptr i8, ptr %sunkaddr27.i, i64 8
  %sunkaddr175 = getelementptr i8, ptr %.849, i64 8
  %sunkaddr176 = shl i64 %arg.bend.6.1, 1
  %sunkaddr184 = getelementptr i8, ptr %sunkaddr27.i, i64 24
  %sunkaddr186 = shl i64 %arg.bend.6.1, 2
  %sunkaddr190 = getelementptr i8, ptr %sunkaddr27.i, i64 32
  %130 = icmp slt i64 %.2980, %arg.qdd.5.1
  %.1020.1.i = getelementptr i8, ptr %arg.X_WO.4, i64 %arg.X_WO.6.1
  %.1017.2.i = shl i64 %arg.X_WO.6.1, 1
  %.1020.2.i = getelementptr i8, ptr %arg.X_WO.4, i64 %.1017.2.i
  %gep.2.i = getelementptr double, ptr %arg.room.4, i64 %.1437.2.i
  %gep1130.1.i = getelementptr i8, ptr %invariant.gep1129.i, i64 %arg.X_WO.6.0
  %.764.1.i = getelementptr i8, ptr %arg.ride.4, i64 %arg.ride.6.0
  %131 = getelementptr i8, ptr %arg.X_WO.4, i64 %arg.X_WO.6.0
  %.1020.1.1.i = getelementptr i8, ptr %131, i64 %arg.X_WO.6.1
  %gep.1.1.i = getelementptr double, ptr %.1904.1.i, i64 %arg.room.5.2
  %.1020.2.1.i = getelementptr i8, ptr %131, i64 %.1017.2.i
  %gep.2.1.i = getelementptr double, ptr %.1904.1.i, i64 %.1437.2.i
  %.615.2.i = shl i64 %arg.X_WO.6.0, 1
  %gep1130.2.i = getelementptr i8, ptr %invariant.gep1129.i, i64 %.615.2.i
  %.762.2.i = shl i64 %arg.ride.6.0, 1
  %.764.2.i = getelementptr i8, ptr %arg.ride.4, i64 %.762.2.i
  %gep713.peel.i = getelementptr double, ptr %invariant.gep710.peel.i, i64 %.432
  %gep711.1.peel.i = getelementptr double, ptr %invariant.gep710.peel.i, i64 %arg.room.5.2
  %gep713.1.peel.i = getelementptr double, ptr %invariant.gep710.peel.i, i64 %.1496.1.i
  %gep711.2.peel.i = getelementptr double, ptr %invariant.gep710.peel.i, i64 %.1437.2.i
  %gep713.2.peel.i = getelementptr double, ptr %invariant.gep710.peel.i, i64 %.1496.2.i
  %132 = icmp samesign ult i64 %..259, 44
  %133 = icmp eq i64 %..259, %n.vec
  %134 = and i64 %..259, 1
  %135 = icmp eq i64 %134, 0
  %.771.i = getelementptr i8, ptr %.747, i64 24
  %.829.i = getelementptr i8, ptr %127, i64 24
  %.771.1.i = getelementptr i8, ptr %.747, i64 32
  %.829.1.i = getelementptr i8, ptr %127, i64 32
  %136 = getelementptr i8, ptr %arg.X_WO.4, i64 %.615.2.i
  %.1020.1.2.i = getelementptr i8, ptr %136, i64 %arg.X_WO.6.1
  %.1020.2.2.i = getelementptr i8, ptr %136, i64 %.1017.2.i
  %gep.2.2.i = getelementptr double, ptr %invariant.gep.2.i, i64 %.1437.2.i
  br label %B182

B336.lr.ph:                                       ; preds = %part.5
  %.1658 = mul i64 %.114610881156, %arg.qd.5.1
  %137 = getelementptr double, ptr %arg.qd.4, i64 %.1658
  %.1713 = mul i64 %.114610881156, %arg.qdd.5.1
  %138 = getelementptr double, ptr %arg.qdd.4, i64 %.1713
  br i1 %132, label %B336.preheader, label %vector.scevcheck

vector.scevcheck:                                 ; preds = %B336.lr.ph
  %139 = getelementptr i8, ptr %scevgep, i64 %59
  %140 = icmp ult ptr %139, %scevgep
  %141 = getelementptr i8, ptr %scevgep69, i64 %59
  %142 = icmp ult ptr %141, %scevgep69
  %143 = or i1 %75, %140
  %144 = or i1 %142, %143
  %brmerge = select i1 %144, i1 true, i1 %conflict.rdx98
  br i1 %brmerge, label %B336.preheader, label %vector.body

vector.body:                                      ; preds = %vector.scevcheck, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %vector.scevcheck ]
  %scevgep107 = getelementptr i8, ptr %lsr.iv, i64 %index
  %scevgep108 = getelementptr i8, ptr %scevgep107, i64 -3
  %scevgep106 = getelementptr i8, ptr %scevgep107, i64 -2
  %scevgep104 = getelementptr i8, ptr %scevgep107, i64 -1
  %145 = load double, ptr %scevgep108, align 8, !alias.scope !49
  %146 = load double, ptr %scevgep106, align 8, !alias.scope !49
  %147 = insertelement <2 x double> poison, double %145, i64 0
  %148 = insertelement <2 x double> %147, double %146, i64 1
  %149 = load double, ptr %scevgep104, align 8, !alias.scope !49
  %150 = load double, ptr %scevgep107, align 8, !alias.scope !49
  %151 = insertelement <2 x double> poison, double %149, i64 0
  %152 = insertelement <2 x double> %151, double %150, i64 1
  %scevgep117 = getelementptr i8, ptr %lsr.iv110, i64 %index
  %scevgep118 = getelementptr i8, ptr %scevgep117, i64 -3
  %scevgep116 = getelementptr i8, ptr %scevgep117, i64 -2
  %scevgep114 = getelementptr i8, ptr %scevgep117, i64 -1
  %153 = load double, ptr %scevgep118, align 8, !alias.scope !52
  %154 = load double, ptr %scevgep116, align 8, !alias.scope !52
  %155 = insertelement <2 x double> poison, double %153, i64 0
  %156 = insertelement <2 x double> %155, double %154, i64 1
  %157 = load double, ptr %scevgep114, align 8, !alias.scope !52
  %158 = load double, ptr %scevgep117, align 8, !alias.scope !52
  %159 = insertelement <2 x double> poison, double %157, i64 0
  %160 = insertelement <2 x double> %159, double %158, i64 1
  %161 = shl i64 %index, 3
  %scevgep123 = getelementptr i8, ptr %lsr.iv120, i64 %161
  %scevgep124 = getelementptr i8, ptr %scevgep123, i64 -16
  store <2 x double> %148, ptr %scevgep124, align 8, !alias.scope !54, !noalias !56
  store <2 x double> %152, ptr %scevgep123, align 8, !alias.scope !54, !noalias !56
  %scevgep129 = getelementptr i8, ptr %lsr.iv126, i64 %161
  %scevgep130 = getelementptr i8, ptr %scevgep129, i64 -16
  store <2 x double> %156, ptr %scevgep130, align 8, !alias.scope !58, !noalias !59
  store <2 x double> %160, ptr %scevgep129, align 8, !alias.scope !58, !noalias !59
  %index.next = add nuw nsw i64 %index, 4
  %162 = icmp eq i64 %n.vec, %index.next
  br i1 %162, label %middle.block, label %vector.body, !llvm.loop !60

middle.block:                                     ; preds = %vector.body
  br i1 %133, label %B402.endif.endif, label %B336.preheader

B336.preheader:                                   ; preds = %middle.block, %vector.scevcheck, %B336.lr.ph
  %.146910651067.ph = phi i64 [ %n.vec, %middle.block ], [ 0, %vector.scevcheck ], [ 0, %B336.lr.ph ]
  %.neg = or disjoint i64 %.146910651067.ph, 1
  br i1 %135, label %B336.prol.loopexit, label %B336.prol

B336.prol:                                        ; preds = %B336.preheader
  %.1548.prol = mul i64 %.146910651067.ph, %arg.rail_rate.6.1
  %.1551.prol = getelementptr i8, ptr %scevgep, i64 %.1548.prol
  %.1553.prol = load double, ptr %.1551.prol, align 8
  %.1603.prol = mul i64 %.146910651067.ph, %arg.rail_bend.6.1
  %.1606.prol = getelementptr i8, ptr %scevgep69, i64 %.1603.prol
  %.1608.prol = load double, ptr %.1606.prol, align 8
  %163 = getelementptr double, ptr %137, i64 %.146910651067.ph
  store double %.1553.prol, ptr %163, align 8
  %164 = getelementptr double, ptr %138, i64 %.146910651067.ph
  store double %.1608.prol, ptr %164, align 8
  br label %B336.prol.loopexit

B336.prol.loopexit:                               ; preds = %B336.prol, %B336.preheader
  %.146910651067.unr = phi i64 [ %.146910651067.ph, %B336.preheader ], [ %.neg, %B336.prol ]
  %165 = icmp eq i64 %..259, %.neg
  br i1 %165, label %B402.endif.endif, label %B336.preheader99

B336.preheader99:                                 ; preds = %B336.prol.loopexit
  %166 = sub i64 %..259, %.146910651067.unr
  %167 = mul i64 %.146910651067.unr, %arg.rail_bend.6.1
  %168 = mul i64 %.146910651067.unr, %arg.rail_rate.6.1
  %169 = add nuw nsw i64 %.146910651067.unr, 1
  %170 = mul i64 %169, %arg.rail_rate.6.1
  %171 = mul i64 %169, %arg.rail_bend.6.1
  %172 = shl i64 %.146910651067.unr, 3
  %scevgep147 = getelementptr i8, ptr %lsr.iv145, i64 %172
  %scevgep154 = getelementptr i8, ptr %lsr.iv152, i64 %172
  br label %B336

B402.endif.endif:                                 ; preds = %B336, %B336.prol.loopexit, %middle.block, %part.5
  %.1893 = mul i64 %.114610881156, %arg.twist.6.0
  %173 = getelementptr i8, ptr %arg.twist.4, i64 %.1893
  %.1899 = load double, ptr %173, align 8
  br i1 %.678.not.i, label %B510.1.thread, label %B470.2

B510.1.thread:                                    ; preds = %B402.endif.endif
  store double %.1899, ptr %.849, align 8
  %.1897.11261 = getelementptr i8, ptr %173, i64 %arg.twist.6.1
  %.1899.11262 = load double, ptr %.1897.11261, align 8
  store double %.1899.11262, ptr %sunkaddr175, align 8
  br label %B510.5

B524.endif:                                       ; preds = %B524.else.endif.if, %B524.else.endif
  %.2092.sroa.0.3 = phi i64 [ %arg.qd.5.1, %B524.else.endif.if ], [ %.2092.sroa.0.1, %B524.else.endif ]
  %.2209 = mul i64 %.114610881156, %arg.qd.5.1
  %174 = getelementptr double, ptr %arg.qd.4, i64 %.2209
  %.2213 = getelementptr double, ptr %174, i64 %.2092.sroa.0.3
  call fastcc void @part.6(ptr nonnull %.2248, ptr %.438, i64 %arg.room.5.2, ptr nonnull %.540, ptr nonnull %.849, i64 %arg.room.5.2, ptr %.2213)
  %.2451 = mul i64 %.114610881156, %arg.qdd.5.1
  %175 = getelementptr double, ptr %arg.qdd.4, i64 %.2451
  %176 = getelementptr double, ptr %175, i64 %.259
  %.2455 = getelementptr double, ptr %176, i64 %.2979
  store double 0.000000e+00, ptr %.2455, align 8
  %177 = getelementptr double, ptr %175, i64 %arg.q.5.1
  %178 = getelementptr i8, ptr %177, i64 -40
  %.2455.1 = getelementptr double, ptr %178, i64 %.2433.1
  store double 0.000000e+00, ptr %.2455.1, align 8
  %179 = getelementptr i8, ptr %177, i64 -32
  %.2455.2 = getelementptr double, ptr %179, i64 %.2433.2
  store double 0.000000e+00, ptr %.2455.2, align 8
  %180 = getelementptr i8, ptr %177, i64 -24
  %.2455.3 = getelementptr double, ptr %180, i64 %.2433.3
  store double 0.000000e+00, ptr %.2455.3, align 8
  %181 = getelementptr i8, ptr %177, i64 -16
  %.2455.4 = getelementptr double, ptr %181, i64 %.2433.4
  store double 0.000000e+00, ptr %.2455.4, align 8
  %182 = getelementptr i8, ptr %177, i64 -8
  %.2455.5 = getelementptr double, ptr %182, i64 %.2433.5
  store double 0.000000e+00, ptr %.2455.5, align 8
  br i1 %.456.not.i, label %B104.us.preheader.i, label %B104.preheader.i

B104.preheader.i:                                 ; preds = %B524.endif
  %.489.i = load double, ptr %arg.ride.4, align 8, !noalias !61
  %.519.i = load double, ptr %174, align 8, !noalias !61
  %.520.i = fmul double %.489.i, %.519.i
  store double %.520.i, ptr %.747, align 8, !noalias !61
  %.620.i = load double, ptr %arg.ride.4, align 8, !noalias !61
  %.650.i = load double, ptr %175, align 8, !noalias !61
  %.651.i = fmul double %.620.i, %.650.i
  store double %.651.i, ptr %127, align 8, !noalias !61
  store double 0.000000e+00, ptr %.771.i, align 8, !noalias !61
  store double 0.000000e+00, ptr %.829.i, align 8, !noalias !61
  %.489.1.i = load double, ptr %.764.1.i, align 8, !noalias !61
  %.519.1.i = load double, ptr %174, align 8, !noalias !61
  %.520.1.i = fmul double %.489.1.i, %.519.1.i
  store double %.520.1.i, ptr %sunkaddr47.i, align 8, !noalias !61
  %.620.1.i = load double, ptr %.764.1.i, align 8, !noalias !61
  %.650.1.i = load double, ptr %175, align 8, !noalias !61
  %.651.1.i = fmul double %.620.1.i, %.650.1.i
  store double %.651.1.i, ptr %sunkaddr45.i41, align 8, !noalias !61
  store double 0.000000e+00, ptr %.771.1.i, align 8, !noalias !61
  store double 0.000000e+00, ptr %.829.1.i, align 8, !noalias !61
  %.489.2.i = load double, ptr %.764.2.i, align 8, !noalias !61
  %.519.2.i = load double, ptr %174, align 8, !noalias !61
  %.520.2.i = fmul double %.489.2.i, %.519.2.i
  store double %.520.2.i, ptr %sunkaddr48.i, align 8, !noalias !61
  %.620.2.i = load double, ptr %.764.2.i, align 8, !noalias !61
  %.650.2.i = load double, ptr %175, align 8, !noalias !61
  %.651.2.i = fmul double %.620.2.i, %.650.2.i
  br label %B252.else.endif.i

B104.us.preheader.i:                              ; preds = %B524.endif
  store double 0.000000e+00, ptr %.747, align 8, !noalias !61
  store double 0.000000e+00, ptr %127, align 8, !noalias !61
  store double 0.000000e+00, ptr %.771.i, align 8, !noalias !61
  store double 0.000000e+00, ptr %.829.i, align 8, !noalias !61
  store double 0.000000e+00, ptr %sunkaddr47.i, align 8, !noalias !61
  store double 0.000000e+00, ptr %sunkaddr45.i41, align 8, !noalias !61
  store double 0.000000e+00, ptr %.771.1.i, align 8, !noalias !61
  store double 0.000000e+00, ptr %.829.1.i, align 8, !noalias !61
  store double 0.000000e+00, ptr %sunkaddr48.i, align 8, !noalias !61
  br label %B252.else.endif.i

B252.else.endif.i:                                ; preds = %B104.us.preheader.i, %B104.preheader.i
  %.651.2.sink.i = phi double [ %.651.2.i, %B104.preheader.i ], [ 0.000000e+00, %B104.us.preheader.i ]
  store double %.651.2.sink.i, ptr %sunkaddr28.i35, align 8, !noalias !61
  store double 0.000000e+00, ptr %.771.2.i, align 8, !noalias !61
  store double 0.000000e+00, ptr %sunkaddr31.i36, align 8, !noalias !61
  %scevgep16.i38 = getelementptr i8, ptr %175, i64 %128
  %scevgep19.i = getelementptr i8, ptr %174, i64 %128
  br label %switch.end.2.i43

switch.end.2.i43:                                 ; preds = %switch.end.2.i43, %B252.else.endif.i
  %lsr.iv13.i = phi ptr [ %scevgep14.i59, %switch.end.2.i43 ], [ %.1427.peel.i, %B252.else.endif.i ]
  %lsr.iv.i44 = phi ptr [ %scevgep1.i58, %switch.end.2.i43 ], [ %invariant.gep.2.i, %B252.else.endif.i ]
  %before_2.2.01439.i = phi double [ %.1616.i, %switch.end.2.i43 ], [ 0.000000e+00, %B252.else.endif.i ]
  %before.2.01438.i = phi double [ %.1470.i, %switch.end.2.i43 ], [ 0.000000e+00, %B252.else.endif.i ]
  %.135314311436.i = phi i64 [ %.1360.i, %switch.end.2.i43 ], [ 0, %B252.else.endif.i ]
  %.1360.i = add nuw nsw i64 %.135314311436.i, 1
  %scevgep15.i45 = getelementptr i8, ptr %lsr.iv13.i, i64 -40
  %.1438.i = load double, ptr %scevgep15.i45, align 8, !noalias !61
  %183 = add nsw i64 %.135314311436.i, %.329.i
  %.1454.i = icmp slt i64 %183, 0
  %184 = select i1 %.1454.i, i64 %64, i64 0
  %scevgep20.i46 = getelementptr i8, ptr %scevgep19.i, i64 %184
  %185 = shl nuw nsw i64 %.135314311436.i, 3
  %scevgep13.i47 = getelementptr i8, ptr %scevgep20.i46, i64 %185
  %.1470.i = load double, ptr %scevgep13.i47, align 8, !noalias !61
  %.1471.i48 = fmul double %.1438.i, %.1470.i
  %.1525.i = load double, ptr %lsr.iv13.i, align 8, !noalias !61
  %.1527.i = fmul double %before.2.01438.i, %.1525.i
  %.1530.i = fsub double %.1471.i48, %.1527.i
  %186 = select i1 %.1454.i, i64 %68, i64 0
  %scevgep17.i49 = getelementptr i8, ptr %scevgep16.i38, i64 %186
  %scevgep11.i50 = getelementptr i8, ptr %scevgep17.i49, i64 %185
  %.1616.i = load double, ptr %scevgep11.i50, align 8, !noalias !61
  %.1617.i = fmul double %.1438.i, %.1616.i
  %.1673.i = fmul double %before_2.2.01439.i, %.1525.i
  %.1676.i = fsub double %.1617.i, %.1673.i
  %sunkaddr15.i = getelementptr i8, ptr %lsr.iv.i44, i64 %sunkaddr54.i
  %sunkaddr16.i = getelementptr i8, ptr %sunkaddr15.i, i64 -16
  %.1800.i = load double, ptr %sunkaddr16.i, align 8, !noalias !61
  %sunkaddr19.i = getelementptr i8, ptr %sunkaddr15.i, i64 -8
  %.1854.i = load double, ptr %sunkaddr19.i, align 8, !noalias !61
  %.1908.i = load double, ptr %sunkaddr15.i, align 8, !noalias !61
  %.1938.i = load double, ptr %sunkaddr23.i, align 8, !noalias !61
  %.1939.i = fmul double %.1800.i, %.1676.i
  %.1969.i = load double, ptr %sunkaddr26.i39, align 8, !noalias !61
  %.1970.i = fmul double %.1908.i, %.1969.i
  %.2000.i = load double, ptr %sunkaddr32.i40, align 8, !noalias !61
  %.2001.i = fmul double %.1854.i, %.2000.i
  %.2002.i = fsub double %.1970.i, %.2001.i
  %.2003.i = fmul double %.1530.i, %.2002.i
  %.2004.i = fadd double %.1939.i, %.2003.i
  %.2005.i = fadd double %.1938.i, %.2004.i
  store double %.2005.i, ptr %sunkaddr23.i, align 8, !noalias !61
  %.2065.i = load double, ptr %sunkaddr35.i, align 8, !noalias !61
  %.2066.i = fmul double %.1676.i, %.1854.i
  %.2096.i = load double, ptr %sunkaddr32.i40, align 8, !noalias !61
  %.2097.i = fmul double %.1800.i, %.2096.i
  %.2127.i51 = load double, ptr %sunkaddr25.i, align 8, !noalias !61
  %.2128.i = fmul double %.1908.i, %.2127.i51
  %.2129.i = fsub double %.2097.i, %.2128.i
  %.2130.i = fmul double %.1530.i, %.2129.i
  %.2131.i = fadd double %.2066.i, %.2130.i
  %.2132.i = fadd double %.2065.i, %.2131.i
  store double %.2132.i, ptr %sunkaddr35.i, align 8, !noalias !61
  %.2192.i = load double, ptr %sunkaddr42.i, align 8, !noalias !61
  %.2193.i = fmul double %.1676.i, %.1908.i
  %.2223.i = load double, ptr %sunkaddr25.i, align 8, !noalias !61
  %.2224.i = fmul double %.1854.i, %.2223.i
  %.2254.i = load double, ptr %sunkaddr26.i39, align 8, !noalias !61
  %.2255.i = fmul double %.1800.i, %.2254.i
  %.2256.i = fsub double %.2224.i, %.2255.i
  %.2257.i = fmul double %.1530.i, %.2256.i
  %.2258.i = fadd double %.2193.i, %.2257.i
  %.2259.i = fadd double %.2192.i, %.2258.i
  store double %.2259.i, ptr %sunkaddr42.i, align 8, !noalias !61
  %.2319.i = load double, ptr %sunkaddr25.i, align 8, !noalias !61
  %.2320.i = fmul double %.1530.i, %.1800.i
  %.2321.i = fadd double %.2320.i, %.2319.i
  store double %.2321.i, ptr %sunkaddr25.i, align 8, !noalias !61
  %.2381.i = load double, ptr %sunkaddr26.i39, align 8, !noalias !61
  %.2382.i = fmul double %.1530.i, %.1854.i
  %.2383.i = fadd double %.2382.i, %.2381.i
  store double %.2383.i, ptr %sunkaddr26.i39, align 8, !noalias !61
  %.2443.i = load double, ptr %sunkaddr32.i40, align 8, !noalias !61
  %.2444.i = fmul double %.1530.i, %.1908.i
  %.2445.i = fadd double %.2444.i, %.2443.i
  store double %.2445.i, ptr %sunkaddr32.i40, align 8, !noalias !61
  %scevgep7.i52 = getelementptr i8, ptr %lsr.iv.i44, i64 %99
  %scevgep10.i53 = getelementptr i8, ptr %scevgep7.i52, i64 -16
  %.2530.i = load double, ptr %scevgep10.i53, align 8, !noalias !61
  %scevgep2.i54 = getelementptr i8, ptr %lsr.iv.i44, i64 %.342.idx.i
  %scevgep3.i55 = getelementptr i8, ptr %scevgep2.i54, i64 -16
  %.2584.i = load double, ptr %scevgep3.i55, align 8, !noalias !61
  %.2585.i = fsub double %.2530.i, %.2584.i
  %scevgep9.i56 = getelementptr i8, ptr %scevgep7.i52, i64 -8
  %.2640.i = load double, ptr %scevgep9.i56, align 8, !noalias !61
  %scevgep5.i57 = getelementptr i8, ptr %scevgep2.i54, i64 -8
  %.2694.i = load double, ptr %scevgep5.i57, align 8, !noalias !61
  %.2695.i = fsub double %.2640.i, %.2694.i
  %.2750.i = load double, ptr %scevgep7.i52, align 8, !noalias !61
  %.2804.i = load double, ptr %scevgep2.i54, align 8, !noalias !61
  %.2805.i = fsub double %.2750.i, %.2804.i
  %.2836.i = fmul double %.2383.i, %.2805.i
  %.2867.i = fmul double %.2445.i, %.2695.i
  %.2868.i = fsub double %.2836.i, %.2867.i
  %.2899.i = fmul double %.2445.i, %.2585.i
  %.2930.i = fmul double %.2321.i, %.2805.i
  %.2931.i = fsub double %.2899.i, %.2930.i
  %.2962.i = fmul double %.2321.i, %.2695.i
  %.2993.i = fmul double %.2383.i, %.2585.i
  %.2994.i = fsub double %.2962.i, %.2993.i
  %.3060.i = load double, ptr %127, align 8, !noalias !61
  %.3090.i = load double, ptr %sunkaddr35.i, align 8, !noalias !61
  %.3091.i = fmul double %.2805.i, %.3090.i
  %.3121.i = load double, ptr %sunkaddr42.i, align 8, !noalias !61
  %.3122.i = fmul double %.2695.i, %.3121.i
  %.3123.i = fsub double %.3091.i, %.3122.i
  %.3156.i = fmul double %.2383.i, %.2994.i
  %.3157.i = fadd double %.3156.i, %.3123.i
  %.3190.i = fmul double %.2445.i, %.2931.i
  %.3191.i = fsub double %.3157.i, %.3190.i
  %.3192.i = fadd double %.3060.i, %.3191.i
  store double %.3192.i, ptr %127, align 8, !noalias !61
  %.3300.i = load double, ptr %sunkaddr45.i41, align 8, !noalias !61
  %.3330.i = load double, ptr %sunkaddr42.i, align 8, !noalias !61
  %.3331.i = fmul double %.2585.i, %.3330.i
  %.3361.i = load double, ptr %sunkaddr23.i, align 8, !noalias !61
  %.3362.i = fmul double %.2805.i, %.3361.i
  %.3363.i = fsub double %.3331.i, %.3362.i
  %.3393.i = load double, ptr %sunkaddr32.i40, align 8, !noalias !61
  %.3396.i = fmul double %.2868.i, %.3393.i
  %.3397.i = fadd double %.3363.i, %.3396.i
  %.3427.i = load double, ptr %sunkaddr25.i, align 8, !noalias !61
  %.3430.i = fmul double %.2994.i, %.3427.i
  %.3431.i = fsub double %.3397.i, %.3430.i
  %.3432.i = fadd double %.3300.i, %.3431.i
  store double %.3432.i, ptr %sunkaddr45.i41, align 8, !noalias !61
  %.3540.i = load double, ptr %sunkaddr46.i42, align 8, !noalias !61
  %.3570.i = load double, ptr %sunkaddr23.i, align 8, !noalias !61
  %.3571.i = fmul double %.2695.i, %.3570.i
  %.3601.i = load double, ptr %sunkaddr35.i, align 8, !noalias !61
  %.3602.i = fmul double %.2585.i, %.3601.i
  %.3603.i = fsub double %.3571.i, %.3602.i
  %.3633.i = load double, ptr %sunkaddr25.i, align 8, !noalias !61
  %.3636.i = fmul double %.2931.i, %.3633.i
  %.3637.i = fadd double %.3603.i, %.3636.i
  %.3667.i = load double, ptr %sunkaddr26.i39, align 8, !noalias !61
  %.3670.i = fmul double %.2868.i, %.3667.i
  %.3671.i = fsub double %.3637.i, %.3670.i
  %.3672.i = fadd double %.3540.i, %.3671.i
  store double %.3672.i, ptr %sunkaddr46.i42, align 8, !noalias !61
  %.3895.i = load double, ptr %.747, align 8, !noalias !61
  %.3910.i = fadd double %.2868.i, %.3895.i
  store double %.3910.i, ptr %.747, align 8, !noalias !61
  %.3895.1.i = load double, ptr %sunkaddr47.i, align 8, !noalias !61
  %.3910.1.i = fadd double %.2931.i, %.3895.1.i
  store double %.3910.1.i, ptr %sunkaddr47.i, align 8, !noalias !61
  %.3895.2.i = load double, ptr %sunkaddr48.i, align 8, !noalias !61
  %.3910.2.i = fadd double %.2994.i, %.3895.2.i
  store double %.3910.2.i, ptr %sunkaddr48.i, align 8, !noalias !61
  %scevgep1.i58 = getelementptr i8, ptr %lsr.iv.i44, i64 %96
  %scevgep14.i59 = getelementptr i8, ptr %lsr.iv13.i, i64 %105
  %exitcond.not.i60 = icmp eq i64 %.1360.i, 6
  br i1 %exitcond.not.i60, label %part.7, label %switch.end.2.i43

part.7: ; preds = %switch.end.2.i43
  %.2826 = mul i64 %.114610881156, %arg.bend.6.0
  %187 = getelementptr i8, ptr %arg.bend.4, i64 %.2826
  %.2832 = load double, ptr %187, align 8
  %.2888 = load double, ptr %sunkaddr27.i, align 8
  %.2889 = fsub double %.2832, %.2888
  store double %.2889, ptr %.849, align 8
  %.2830.1 = getelementptr i8, ptr %187, i64 %arg.bend.6.1
  %.2832.1 = load double, ptr %.2830.1, align 8
  %.2888.1 = load double, ptr %sunkaddr174, align 8
  %.2889.1 = fsub double %.2832.1, %.2888.1
  store double %.2889.1, ptr %sunkaddr175, align 8
  %sunkaddr177 = getelementptr i8, ptr %187, i64 %sunkaddr176
  %.2832.2 = load double, ptr %sunkaddr177, align 8
  %.2888.2 = load double, ptr %sunkaddr28.i35, align 8
  %.2889.2 = fsub double %.2832.2, %.2888.2
  store double %.2889.2, ptr %sunkaddr163, align 8
  %.2830.3 = getelementptr i8, ptr %187, i64 %.2827.3
  %.2832.3 = load double, ptr %.2830.3, align 8
  %.2888.3 = load double, ptr %sunkaddr184, align 8
  %.2889.3 = fsub double %.2832.3, %.2888.3
  store double %.2889.3, ptr %sunkaddr164, align 8
  %sunkaddr187 = getelementptr i8, ptr %187, i64 %sunkaddr186
  %.2832.4 = load double, ptr %sunkaddr187, align 8
  %.2888.4 = load double, ptr %sunkaddr190, align 8
  %.2889.4 = fsub double %.2832.4, %.2888.4
  store double %.2889.4, ptr %sunkaddr167, align 8
  %.2830.5 = getelementptr i8, ptr %187, i64 %.2827.5
  %.2832.5 = load double, ptr %.2830.5, align 8
  %.2888.5 = load double, ptr %sunkaddr31.i36, align 8
  %.2889.5 = fsub double %.2832.5, %.2888.5
  store double %.2889.5, ptr %sunkaddr168, align 8
  br i1 %129, label %B784.else.if, label %B784.else.endif, !prof !30

B524.else.if:                                     ; preds = %B510.5
  br label %B524.else.endif

B524.else.endif:                                  ; preds = %B524.else.if, %B510.5
  %.2092.sroa.0.1 = phi i64 [ 0, %B524.else.if ], [ %.2104, %B510.5 ]
  br i1 %126, label %B524.endif, label %B524.else.endif.if, !prof !64

B524.else.endif.if:                               ; preds = %B524.else.endif
  br label %B524.endif

B784.endif:                                       ; preds = %B784.else.endif.if, %B784.else.endif
  %.2968.sroa.0.3 = phi i64 [ %arg.qdd.5.1, %B784.else.endif.if ], [ %.2968.sroa.0.1, %B784.else.endif ]
  %.3089 = getelementptr double, ptr %175, i64 %.2968.sroa.0.3
  call fastcc void @part.6(ptr nonnull %.3124, ptr %.438, i64 %arg.room.5.2, ptr nonnull %.540, ptr nonnull %.849, i64 %arg.room.5.2, ptr %.3089)
  %scevgep101 = getelementptr i8, ptr %lsr.iv, i64 %arg.rail_rate.6.0
  %scevgep111 = getelementptr i8, ptr %lsr.iv110, i64 %arg.rail_bend.6.0
  %scevgep121 = getelementptr i8, ptr %lsr.iv120, i64 %64
  %scevgep127 = getelementptr i8, ptr %lsr.iv126, i64 %68
  %scevgep133 = getelementptr i8, ptr %lsr.iv132, i64 %arg.rail_bend.6.0
  %scevgep138 = getelementptr i8, ptr %lsr.iv137, i64 %arg.rail_rate.6.0
  %scevgep146 = getelementptr i8, ptr %lsr.iv145, i64 %68
  %scevgep153 = getelementptr i8, ptr %lsr.iv152, i64 %64
  %exitcond1258.not = icmp eq i64 %.1153, %arg.q.5.0
  br i1 %exitcond1258.not, label %B844, label %B182

B784.else.if:                                     ; preds = %part.7
  br label %B784.else.endif

B784.else.endif:                                  ; preds = %B784.else.if, %part.7
  %.2968.sroa.0.1 = phi i64 [ 0, %B784.else.if ], [ %.2980, %part.7 ]
  br i1 %130, label %B784.endif, label %B784.else.endif.if, !prof !64

B784.else.endif.if:                               ; preds = %B784.else.endif
  br label %B784.endif
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #1

; Function Attrs: mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite)
define internal fastcc void @part.6(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, ptr readonly captures(none) %arg.A.4, i64 %arg.A.5.1, ptr readonly captures(none) %arg.order.4, ptr readonly captures(none) %arg.b.4, i64 %arg.b.5.0, ptr writeonly captures(none) initializes((0, 48)) %arg.x.4) unnamed_addr #2 {
common.ret:
  %.218 = load double, ptr %arg.order.4, align 8
  %.5.i = fptosi double %.218 to i64
  %.256 = icmp slt i64 %.5.i, 0
  %.257 = select i1 %.256, i64 %arg.b.5.0, i64 0
  %0 = getelementptr double, ptr %arg.b.4, i64 %.5.i
  %.271 = getelementptr double, ptr %0, i64 %.257
  %.272 = load double, ptr %.271, align 8
  store double %.272, ptr %arg.x.4, align 8
  %1 = getelementptr i8, ptr %arg.order.4, i64 8
  %.218.1 = load double, ptr %1, align 8
  %.5.i4 = fptosi double %.218.1 to i64
  %.256.1 = icmp slt i64 %.5.i4, 0
  %.257.1 = select i1 %.256.1, i64 %arg.b.5.0, i64 0
  %2 = getelementptr double, ptr %arg.b.4, i64 %.5.i4
  %.271.1 = getelementptr double, ptr %2, i64 %.257.1
  %.272.1 = load double, ptr %.271.1, align 8
  %3 = getelementptr i8, ptr %arg.x.4, i64 8
  store double %.272.1, ptr %3, align 8
  %4 = getelementptr double, ptr %arg.A.4, i64 %arg.A.5.1
  %.505.1 = load double, ptr %4, align 8
  %.538.1 = fmul double %.272, %.505.1
  %.539.1 = fsub double %.272.1, %.538.1
  store double %.539.1, ptr %3, align 8
  %5 = getelementptr i8, ptr %arg.order.4, i64 16
  %.218.2 = load double, ptr %5, align 8
  %.5.i5 = fptosi double %.218.2 to i64
  %.256.2 = icmp slt i64 %.5.i5, 0
  %.257.2 = select i1 %.256.2, i64 %arg.b.5.0, i64 0
  %6 = getelementptr double, ptr %arg.b.4, i64 %.5.i5
  %.271.2 = getelementptr double, ptr %6, i64 %.257.2
  %.272.2 = load double, ptr %.271.2, align 8
  %7 = getelementptr i8, ptr %arg.x.4, i64 16
  store double %.272.2, ptr %7, align 8
  %.idx = shl i64 %arg.A.5.1, 4
  %8 = getelementptr i8, ptr %arg.A.4, i64 %.idx
  %.505.2 = load double, ptr %8, align 8
  %.538.2 = fmul double %.272, %.505.2
  %.539.2 = fsub double %.272.2, %.538.2
  store double %.539.2, ptr %7, align 8
  %9 = getelementptr i8, ptr %8, i64 8
  %.505.2.1 = load double, ptr %9, align 8
  %.538.2.1 = fmul double %.539.1, %.505.2.1
  %.539.2.1 = fsub double %.539.2, %.538.2.1
  store double %.539.2.1, ptr %7, align 8
  %10 = getelementptr i8, ptr %arg.order.4, i64 24
  %.218.3 = load double, ptr %10, align 8
  %.5.i6 = fptosi double %.218.3 to i64
  %.256.3 = icmp slt i64 %.5.i6, 0
  %.257.3 = select i1 %.256.3, i64 %arg.b.5.0, i64 0
  %11 = getelementptr double, ptr %arg.b.4, i64 %.5.i6
  %.271.3 = getelementptr double, ptr %11, i64 %.257.3
  %.272.3 = load double, ptr %.271.3, align 8
  %12 = getelementptr i8, ptr %arg.x.4, i64 24
  store double %.272.3, ptr %12, align 8
  %.idx448 = mul i64 %arg.A.5.1, 24
  %13 = getelementptr i8, ptr %arg.A.4, i64 %.idx448
  %.505.3 = load double, ptr %13, align 8
  %.538.3 = fmul double %.272, %.505.3
  %.539.3 = fsub double %.272.3, %.538.3
  store double %.539.3, ptr %12, align 8
  %14 = getelementptr i8, ptr %13, i64 8
  %.505.3.1 = load double, ptr %14, align 8
  %.538.3.1 = fmul double %.539.1, %.505.3.1
  %.539.3.1 = fsub double %.539.3, %.538.3.1
  store double %.539.3.1, ptr %12, align 8
  %15 = getelementptr i8, ptr %13, i64 16
  %.505.3.2 = load double, ptr %15, align 8
  %.538.3.2 = fmul double %.539.2.1, %.505.3.2
  %.539.3.2 = fsub double %.539.3.1, %.538.3.2
  store double %.539.3.2, ptr %12, align 8
  %16 = getelementptr i8, ptr %arg.order.4, i64 32
  %.218.4 = load double, ptr %16, align 8
  %.5.i7 = fptosi double %.218.4 to i64
  %.256.4 = icmp slt i64 %.5.i7, 0
  %.257.4 = select i1 %.256.4, i64 %arg.b.5.0, i64 0
  %17 = getelementptr double, ptr %arg.b.4, i64 %.5.i7
  %.271.4 = getelementptr double, ptr %17, i64 %.257.4
  %.272.4 = load double, ptr %.271.4, align 8
  %18 = getelementptr i8, ptr %arg.x.4, i64 32
  store double %.272.4, ptr %18, align 8
  %.idx449 = shl i64 %arg.A.5.1, 5
  %19 = getelementptr i8, ptr %arg.A.4, i64 %.idx449
  %.505.4 = load double, ptr %19, align 8
  %.538.4 = fmul double %.272, %.505.4
  %.539.4 = fsub double %.272.4, %.538.4
  store double %.539.4, ptr %18, align 8
  %20 = getelementptr i8, ptr %19, i64 8
  %.505.4.1 = load double, ptr %20, align 8
  %.538.4.1 = fmul double %.539.1, %.505.4.1
  %.539.4.1 = fsub double %.539.4, %.538.4.1
  store double %.539.4.1, ptr %18, align 8
  %21 = getelementptr i8, ptr %19, i64 16
  %.505.4.2 = load double, ptr %21, align 8
  %.538.4.2 = fmul double %.539.2.1, %.505.4.2
  %.539.4.2 = fsub double %.539.4.1, %.538.4.2
  store double %.539.4.2, ptr %18, align 8
  %22 = getelementptr i8, ptr %19, i64 24
  %.505.4.3 = load double, ptr %22, align 8
  %.538.4.3 = fmul double %.539.3.2, %.505.4.3
  %.539.4.3 = fsub double %.539.4.2, %.538.4.3
  store double %.539.4.3, ptr %18, align 8
  %23 = getelementptr i8, ptr %arg.order.4, i64 40
  %.218.5 = load double, ptr %23, align 8
  %.5.i8 = fptosi double %.218.5 to i64
  %.256.5 = icmp slt i64 %.5.i8, 0
  %.257.5 = select i1 %.256.5, i64 %arg.b.5.0, i64 0
  %24 = getelementptr double, ptr %arg.b.4, i64 %.5.i8
  %.271.5 = getelementptr double, ptr %24, i64 %.257.5
  %.272.5 = load double, ptr %.271.5, align 8
  %25 = getelementptr i8, ptr %arg.x.4, i64 40
  store double %.272.5, ptr %25, align 8
  %.idx450 = mul i64 %arg.A.5.1, 40
  %26 = getelementptr i8, ptr %arg.A.4, i64 %.idx450
  %.505.5 = load double, ptr %26, align 8
  %.538.5 = fmul double %.272, %.505.5
  %.539.5 = fsub double %.272.5, %.538.5
  store double %.539.5, ptr %25, align 8
  %27 = getelementptr i8, ptr %26, i64 8
  %.505.5.1 = load double, ptr %27, align 8
  %.538.5.1 = fmul double %.539.1, %.505.5.1
  %.539.5.1 = fsub double %.539.5, %.538.5.1
  store double %.539.5.1, ptr %25, align 8
  %28 = getelementptr i8, ptr %26, i64 16
  %.505.5.2 = load double, ptr %28, align 8
  %.538.5.2 = fmul double %.539.2.1, %.505.5.2
  %.539.5.2 = fsub double %.539.5.1, %.538.5.2
  store double %.539.5.2, ptr %25, align 8
  %29 = getelementptr i8, ptr %26, i64 24
  %.505.5.3 = load double, ptr %29, align 8
  %.538.5.3 = fmul double %.539.3.2, %.505.5.3
  %.539.5.3 = fsub double %.539.5.2, %.538.5.3
  store double %.539.5.3, ptr %25, align 8
  %30 = getelementptr i8, ptr %26, i64 32
  %.505.5.4 = load double, ptr %30, align 8
  %.538.5.4 = fmul double %.539.4.3, %.505.5.4
  %.539.5.4 = fsub double %.539.5.3, %.538.5.4
  store double %.539.5.4, ptr %25, align 8
  %31 = getelementptr i8, ptr %26, i64 40
  %.1070 = load double, ptr %31, align 8
  %.1076 = fdiv double %.539.5.4, %.1070
  store double %.1076, ptr %25, align 8
  %32 = getelementptr i8, ptr %19, i64 40
  %.915.1 = load double, ptr %32, align 8
  %.948.1 = fmul double %.1076, %.915.1
  %.949.1 = fsub double %.539.4.3, %.948.1
  store double %.949.1, ptr %18, align 8
  %33 = getelementptr i8, ptr %19, i64 32
  %.1070.1 = load double, ptr %33, align 8
  %.1076.1 = fdiv double %.949.1, %.1070.1
  store double %.1076.1, ptr %18, align 8
  %34 = getelementptr i8, ptr %13, i64 32
  %.915.2 = load double, ptr %34, align 8
  %.948.2 = fmul double %.1076.1, %.915.2
  %.949.2 = fsub double %.539.3.2, %.948.2
  store double %.949.2, ptr %12, align 8
  %35 = getelementptr i8, ptr %13, i64 40
  %.915.2.1 = load double, ptr %35, align 8
  %.948.2.1 = fmul double %.1076, %.915.2.1
  %.949.2.1 = fsub double %.949.2, %.948.2.1
  store double %.949.2.1, ptr %12, align 8
  %36 = getelementptr i8, ptr %13, i64 24
  %.1070.2 = load double, ptr %36, align 8
  %.1076.2 = fdiv double %.949.2.1, %.1070.2
  store double %.1076.2, ptr %12, align 8
  %37 = getelementptr i8, ptr %8, i64 24
  %.915.3 = load double, ptr %37, align 8
  %.948.3 = fmul double %.1076.2, %.915.3
  %.949.3 = fsub double %.539.2.1, %.948.3
  store double %.949.3, ptr %7, align 8
  %38 = getelementptr i8, ptr %8, i64 32
  %.915.3.1 = load double, ptr %38, align 8
  %.948.3.1 = fmul double %.1076.1, %.915.3.1
  %.949.3.1 = fsub double %.949.3, %.948.3.1
  store double %.949.3.1, ptr %7, align 8
  %39 = getelementptr i8, ptr %8, i64 40
  %.915.3.2 = load double, ptr %39, align 8
  %.948.3.2 = fmul double %.1076, %.915.3.2
  %.949.3.2 = fsub double %.949.3.1, %.948.3.2
  store double %.949.3.2, ptr %7, align 8
  %40 = getelementptr i8, ptr %8, i64 16
  %.1070.3 = load double, ptr %40, align 8
  %.1076.3 = fdiv double %.949.3.2, %.1070.3
  store double %.1076.3, ptr %7, align 8
  %41 = getelementptr i8, ptr %4, i64 16
  %.915.4 = load double, ptr %41, align 8
  %.948.4 = fmul double %.1076.3, %.915.4
  %.949.4 = fsub double %.539.1, %.948.4
  store double %.949.4, ptr %3, align 8
  %42 = getelementptr i8, ptr %4, i64 24
  %.915.4.1 = load double, ptr %42, align 8
  %.948.4.1 = fmul double %.1076.2, %.915.4.1
  %.949.4.1 = fsub double %.949.4, %.948.4.1
  store double %.949.4.1, ptr %3, align 8
  %43 = getelementptr i8, ptr %4, i64 32
  %.915.4.2 = load double, ptr %43, align 8
  %.948.4.2 = fmul double %.1076.1, %.915.4.2
  %.949.4.2 = fsub double %.949.4.1, %.948.4.2
  store double %.949.4.2, ptr %3, align 8
  %44 = getelementptr i8, ptr %4, i64 40
  %.915.4.3 = load double, ptr %44, align 8
  %.948.4.3 = fmul double %.1076, %.915.4.3
  %.949.4.3 = fsub double %.949.4.2, %.948.4.3
  store double %.949.4.3, ptr %3, align 8
  %45 = getelementptr i8, ptr %4, i64 8
  %.1070.4 = load double, ptr %45, align 8
  %.1076.4 = fdiv double %.949.4.3, %.1070.4
  store double %.1076.4, ptr %3, align 8
  %46 = getelementptr i8, ptr %arg.A.4, i64 8
  %.915.5 = load double, ptr %46, align 8
  %.948.5 = fmul double %.1076.4, %.915.5
  %.949.5 = fsub double %.272, %.948.5
  store double %.949.5, ptr %arg.x.4, align 8
  %47 = getelementptr i8, ptr %arg.A.4, i64 16
  %.915.5.1 = load double, ptr %47, align 8
  %.948.5.1 = fmul double %.1076.3, %.915.5.1
  %.949.5.1 = fsub double %.949.5, %.948.5.1
  store double %.949.5.1, ptr %arg.x.4, align 8
  %48 = getelementptr i8, ptr %arg.A.4, i64 24
  %.915.5.2 = load double, ptr %48, align 8
  %.948.5.2 = fmul double %.1076.2, %.915.5.2
  %.949.5.2 = fsub double %.949.5.1, %.948.5.2
  store double %.949.5.2, ptr %arg.x.4, align 8
  %49 = getelementptr i8, ptr %arg.A.4, i64 32
  %.915.5.3 = load double, ptr %49, align 8
  %.948.5.3 = fmul double %.1076.1, %.915.5.3
  %.949.5.3 = fsub double %.949.5.2, %.948.5.3
  store double %.949.5.3, ptr %arg.x.4, align 8
  %50 = getelementptr i8, ptr %arg.A.4, i64 40
  %.915.5.4 = load double, ptr %50, align 8
  %.948.5.4 = fmul double %.1076, %.915.5.4
  %.949.5.4 = fsub double %.949.5.3, %.948.5.4
  store double %.949.5.4, ptr %arg.x.4, align 8
  %.1070.5 = load double, ptr %arg.A.4, align 8
  %.1076.5 = fdiv double %.949.5.4, %.1070.5
  store double %.1076.5, ptr %arg.x.4, align 8
  store ptr null, ptr %retptr, align 8
  ret void
}

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #1 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #2 = { mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite) }

!0 = !{!1}
!1 = distinct !{!1, !2, !"part.1: %retptr"}
!2 = distinct !{!2, !"part.1"}
!3 = distinct !{!3, !4}
!4 = !{!"llvm.loop.peeled.count", i32 1}
!5 = distinct !{!5, !4}
!6 = distinct !{!6, !4}
!7 = !{!8}
!8 = distinct !{!8, !9, !"part.1: %retptr"}
!9 = distinct !{!9, !"part.1"}
!10 = distinct !{!10, !4}
!11 = !{!12}
!12 = distinct !{!12, !13, !"part.8: %retptr"}
!13 = distinct !{!13, !"part.8"}
!14 = distinct !{!14, !15}
!15 = !{!"llvm.loop.isvectorized", i32 1}
!16 = !{!17}
!17 = distinct !{!17, !18}
!18 = distinct !{!18, !"LVerDomain"}
!19 = !{!20}
!20 = distinct !{!20, !18}
!21 = distinct !{!21, !15, !22}
!22 = !{!"llvm.loop.unroll.runtime.disable"}
!23 = !{!24}
!24 = distinct !{!24, !25, !"part.1: %retptr"}
!25 = distinct !{!25, !"part.1"}
!26 = distinct !{!26, !4}
!27 = !{!28}
!28 = distinct !{!28, !29, !"part.9: %retptr"}
!29 = distinct !{!29, !"part.9"}
!30 = !{!"branch_weights", i32 1, i32 99}
!31 = !{!32}
!32 = distinct !{!32, !33, !"part.1: %retptr"}
!33 = distinct !{!33, !"part.1"}
!34 = distinct !{!34, !4}
!35 = !{!36}
!36 = distinct !{!36, !37, !"part.10: %retptr"}
!37 = distinct !{!37, !"part.10"}
!38 = distinct !{!38, !4}
!39 = !{!40}
!40 = distinct !{!40, !41, !"part.11: %retptr"}
!41 = distinct !{!41, !"part.11"}
!42 = !{!43}
!43 = distinct !{!43, !44}
!44 = distinct !{!44, !"LVerDomain"}
!45 = distinct !{!45, !15, !22}
!46 = distinct !{!46, !15}
!47 = distinct !{!47, !15}
!48 = !{!"branch_weights", i32 0, i32 -2147483648}
!49 = !{!50}
!50 = distinct !{!50, !51}
!51 = distinct !{!51, !"LVerDomain"}
!52 = !{!53}
!53 = distinct !{!53, !51}
!54 = !{!55}
!55 = distinct !{!55, !51}
!56 = !{!57, !50, !53}
!57 = distinct !{!57, !51}
!58 = !{!57}
!59 = !{!50, !53}
!60 = distinct !{!60, !15, !22}
!61 = !{!62}
!62 = distinct !{!62, !63, !"part.12: %retptr"}
!63 = distinct !{!63, !"part.12"}
!64 = !{!"branch_weights", i32 99, i32 1}
