; sha256 130a2889b3e17f71f2f3ae0afaca271b69e98173e9b8fb642c204bef675c127f of srs_loops.py and of this
; made by numba 0.68.1, llvmlite 0.50.0, Python 3.11.7
; loops.fill_force: array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 2d, C); array(float64, 2d, C); array(float64, 2d, C); array(float64, 1d, C)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.fill_force(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.arm.0, ptr readnone captures(none) %arg.arm.1, i64 %arg.arm.2, i64 %arg.arm.3, ptr readonly captures(none) %arg.arm.4, i64 %arg.arm.5.0, i64 %arg.arm.6.0, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.6.0, ptr readnone captures(none) %arg.tau.0, ptr readnone captures(none) %arg.tau.1, i64 %arg.tau.2, i64 %arg.tau.3, ptr readonly captures(none) %arg.tau.4, i64 %arg.tau.5.0, i64 %arg.tau.6.0, ptr readnone captures(none) %arg.frame.0, ptr readnone captures(none) %arg.frame.1, i64 %arg.frame.2, i64 %arg.frame.3, ptr initializes((0, 24)) %arg.frame.4, i64 %arg.frame.5.0, i64 %arg.frame.5.1, i64 %arg.frame.6.0, i64 %arg.frame.6.1, ptr readnone captures(none) %arg.J.0, ptr readnone captures(none) %arg.J.1, i64 %arg.J.2, i64 %arg.J.3, ptr initializes((0, 8)) %arg.J.4, i64 %arg.J.5.0, i64 %arg.J.5.1, i64 %arg.J.6.0, i64 %arg.J.6.1, ptr readnone captures(none) %arg.L.0, ptr readnone captures(none) %arg.L.1, i64 %arg.L.2, i64 %arg.L.3, ptr captures(none) %arg.L.4, i64 %arg.L.5.0, i64 %arg.L.5.1, i64 %arg.L.6.0, i64 %arg.L.6.1, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.6.0) local_unnamed_addr #0 {
B0:
  store double 1.000000e+00, ptr %arg.frame.4, align 8, !noalias !0
  %0 = getelementptr i8, ptr %arg.frame.4, i64 8
  %1 = getelementptr i8, ptr %arg.frame.4, i64 16
  %2 = getelementptr double, ptr %arg.frame.4, i64 %arg.frame.5.1
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %0, i8 0, i64 16, i1 false), !noalias !0
  store double 0.000000e+00, ptr %2, align 8, !noalias !0
  %3 = getelementptr i8, ptr %2, i64 8
  store double 1.000000e+00, ptr %3, align 8, !noalias !0
  %4 = getelementptr i8, ptr %2, i64 16
  store double 0.000000e+00, ptr %4, align 8, !noalias !0
  %.idx1176.i = shl i64 %arg.frame.5.1, 4
  %5 = getelementptr i8, ptr %arg.frame.4, i64 %.idx1176.i
  %6 = getelementptr i8, ptr %5, i64 8
  %7 = getelementptr i8, ptr %5, i64 16
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %5, i8 0, i64 16, i1 false), !noalias !0
  store double 1.000000e+00, ptr %7, align 8, !noalias !0
  %.idx1177.i = mul i64 %arg.frame.5.1, 24
  %8 = getelementptr i8, ptr %arg.frame.4, i64 %.idx1177.i
  %9 = getelementptr i8, ptr %8, i64 16
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %8, i8 0, i64 24, i1 false), !noalias !0
  %.427.i = load double, ptr %arg.arm.4, align 8, !noalias !0
  store double %.427.i, ptr %9, align 8, !noalias !0
  %.1024.peel.i = load double, ptr %arg.q.4, align 8, !noalias !0
  %.1349.peel.i = load double, ptr %5, align 8, !noalias !0
  %gep1124.peel.idx.i = mul i64 %arg.J.5.1, 24
  %gep1124.peel.i = getelementptr i8, ptr %arg.J.4, i64 %gep1124.peel.idx.i
  store double %.1349.peel.i, ptr %gep1124.peel.i, align 8, !noalias !0
  store double 0.000000e+00, ptr %arg.J.4, align 8, !noalias !0
  %.1349.1.peel.i = load double, ptr %6, align 8, !noalias !0
  %.1406.1.peel.i = getelementptr i8, ptr %8, i64 8
  %.1407.1.peel.i = load double, ptr %.1406.1.peel.i, align 8, !noalias !0
  %gep1124.1.peel.idx.i = shl i64 %arg.J.5.1, 5
  %gep1124.1.peel.i = getelementptr i8, ptr %arg.J.4, i64 %gep1124.1.peel.idx.i
  store double %.1349.1.peel.i, ptr %gep1124.1.peel.i, align 8, !noalias !0
  %gep1126.1.peel.i = getelementptr double, ptr %arg.J.4, i64 %arg.J.5.1
  store double %.1407.1.peel.i, ptr %gep1126.1.peel.i, align 8, !noalias !0
  %.1349.2.peel.i = load double, ptr %7, align 8, !noalias !0
  %.1407.2.peel.i = load double, ptr %9, align 8, !noalias !0
  %gep1124.2.peel.idx.i = mul i64 %arg.J.5.1, 40
  %gep1124.2.peel.i = getelementptr i8, ptr %arg.J.4, i64 %gep1124.2.peel.idx.i
  store double %.1349.2.peel.i, ptr %gep1124.2.peel.i, align 8, !noalias !0
  %gep1126.2.peel.idx.i = shl i64 %arg.J.5.1, 4
  %gep1126.2.peel.i = getelementptr i8, ptr %arg.J.4, i64 %gep1126.2.peel.idx.i
  store double %.1407.2.peel.i, ptr %gep1126.2.peel.i, align 8, !noalias !0
  %.1025.peel.i = tail call double @llvm.cos.f64(double %.1024.peel.i)
  %.1057.peel.i = tail call double @llvm.sin.f64(double %.1024.peel.i)
  %.1697.peel.i = load double, ptr %arg.frame.4, align 8, !noalias !0
  %.1752.peel.i = load double, ptr %2, align 8, !noalias !0
  %.1756.peel.i = fmul double %.1025.peel.i, %.1697.peel.i
  %.1760.peel.i = fmul double %.1057.peel.i, %.1752.peel.i
  %.1761.peel.i = fadd double %.1756.peel.i, %.1760.peel.i
  %.1763.peel.i = fmul double %.1025.peel.i, %.1752.peel.i
  %.1767.peel.i = fmul double %.1057.peel.i, %.1697.peel.i
  %.1768.peel.i = fsub double %.1763.peel.i, %.1767.peel.i
  store double %.1761.peel.i, ptr %arg.frame.4, align 8, !noalias !0
  store double %.1768.peel.i, ptr %2, align 8, !noalias !0
  %.1697.1.peel.i = load double, ptr %0, align 8, !noalias !0
  %.1752.1.peel.i = load double, ptr %3, align 8, !noalias !0
  %.1756.1.peel.i = fmul double %.1025.peel.i, %.1697.1.peel.i
  %.1760.1.peel.i = fmul double %.1057.peel.i, %.1752.1.peel.i
  %.1761.1.peel.i = fadd double %.1756.1.peel.i, %.1760.1.peel.i
  %.1763.1.peel.i = fmul double %.1025.peel.i, %.1752.1.peel.i
  %.1767.1.peel.i = fmul double %.1057.peel.i, %.1697.1.peel.i
  %.1768.1.peel.i = fsub double %.1763.1.peel.i, %.1767.1.peel.i
  store double %.1761.1.peel.i, ptr %0, align 8, !noalias !0
  store double %.1768.1.peel.i, ptr %3, align 8, !noalias !0
  %.1697.2.peel.i = load double, ptr %1, align 8, !noalias !0
  %.1752.2.peel.i = load double, ptr %4, align 8, !noalias !0
  %.1756.2.peel.i = fmul double %.1025.peel.i, %.1697.2.peel.i
  %.1760.2.peel.i = fmul double %.1057.peel.i, %.1752.2.peel.i
  %.1761.2.peel.i = fadd double %.1756.2.peel.i, %.1760.2.peel.i
  %.1763.2.peel.i = fmul double %.1025.peel.i, %.1752.2.peel.i
  %.1767.2.peel.i = fmul double %.1057.peel.i, %.1697.2.peel.i
  %.1768.2.peel.i = fsub double %.1763.2.peel.i, %.1767.2.peel.i
  store double %.1761.2.peel.i, ptr %1, align 8, !noalias !0
  store double %.1768.2.peel.i, ptr %4, align 8, !noalias !0
  %10 = shl i64 %arg.J.5.1, 3
  %scevgep13.i = getelementptr i8, ptr %arg.J.4, i64 %10
  br label %B162.i

B162.i:                                           ; preds = %B322.else.if.i, %B0
  %.56811361152.i = phi i64 [ 1, %B0 ], [ %.575.i, %B322.else.if.i ]
  %.575.i = add nuw nsw i64 %.56811361152.i, 1
  switch i64 %.56811361152.i, label %B162.B322.else.if_crit_edge.i [
    i64 3, label %11
    i64 5, label %B218.endif.i
  ]

B162.B322.else.if_crit_edge.i:                    ; preds = %B162.i
  %.1407.pre.i = load double, ptr %8, align 8, !noalias !0
  %.pre.i = shl nuw nsw i64 %.56811361152.i, 3
  br label %B322.else.if.i

11:                                               ; preds = %B162.i
  br label %B218.endif.i

B218.endif.i:                                     ; preds = %11, %B162.i
  %.60410611180.i = phi i1 [ true, %11 ], [ false, %B162.i ]
  %12 = phi i64 [ 1, %11 ], [ 2, %B162.i ]
  %.853.i = getelementptr double, ptr %arg.arm.4, i64 %12
  %.783.i = load double, ptr %8, align 8, !noalias !0
  %.854.i = load double, ptr %.853.i, align 8, !noalias !0
  %13 = shl nuw nsw i64 %.56811361152.i, 3
  %scevgep9.i = getelementptr i8, ptr %gep1124.peel.i, i64 %13
  %scevgep15.i = getelementptr i8, ptr %scevgep9.i, i64 -8
  %.919.i = load double, ptr %scevgep15.i, align 8, !noalias !0
  %.922.i = fmul double %.854.i, %.919.i
  %.924.i = fadd double %.783.i, %.922.i
  store double %.924.i, ptr %8, align 8, !noalias !0
  %.783.1.i = load double, ptr %.1406.1.peel.i, align 8, !noalias !0
  %.854.1.i = load double, ptr %.853.i, align 8, !noalias !0
  %scevgep20.i = getelementptr i8, ptr %gep1124.1.peel.i, i64 %13
  %scevgep21.i = getelementptr i8, ptr %scevgep20.i, i64 -8
  %.919.1.i = load double, ptr %scevgep21.i, align 8, !noalias !0
  %.922.1.i = fmul double %.854.1.i, %.919.1.i
  %.924.1.i = fadd double %.783.1.i, %.922.1.i
  store double %.924.1.i, ptr %.1406.1.peel.i, align 8, !noalias !0
  %.783.2.i = load double, ptr %9, align 8, !noalias !0
  %.854.2.i = load double, ptr %.853.i, align 8, !noalias !0
  %scevgep24.i = getelementptr i8, ptr %gep1124.2.peel.i, i64 %13
  %scevgep25.i = getelementptr i8, ptr %scevgep24.i, i64 -8
  %.919.2.i = load double, ptr %scevgep25.i, align 8, !noalias !0
  %.922.2.i = fmul double %.854.2.i, %.919.2.i
  %.924.2.i = fadd double %.783.2.i, %.922.2.i
  store double %.924.2.i, ptr %9, align 8, !noalias !0
  br i1 %.60410611180.i, label %14, label %B322.else.if.i

14:                                               ; preds = %B218.endif.i
  br label %B322.else.if.i

B322.else.if.i:                                   ; preds = %14, %B218.endif.i, %B162.B322.else.if_crit_edge.i
  %.pre-phi.i = phi i64 [ %13, %14 ], [ %13, %B218.endif.i ], [ %.pre.i, %B162.B322.else.if_crit_edge.i ]
  %.1407.i = phi double [ %.924.i, %14 ], [ %.924.i, %B218.endif.i ], [ %.1407.pre.i, %B162.B322.else.if_crit_edge.i ]
  %.6041062.i = phi double [ -1.000000e+00, %14 ], [ 1.000000e+00, %B218.endif.i ], [ 1.000000e+00, %B162.B322.else.if_crit_edge.i ]
  %scevgep.i = getelementptr i8, ptr %arg.q.4, i64 %.pre-phi.i
  %.1024.i = load double, ptr %scevgep.i, align 8, !noalias !0
  %15 = and i64 %.56811361152.i, 1
  %spec.select1097.i = xor i64 %15, 1
  %spec.select1098.i = shl nuw nsw i64 %15, 1
  %.1152.i = xor i64 %spec.select1098.i, 3
  %.1154.i = sub nuw nsw i64 %.1152.i, %spec.select1097.i
  %.1344.i = mul i64 %.1154.i, %arg.frame.5.1
  %16 = getelementptr double, ptr %arg.frame.4, i64 %.1344.i
  %scevgep1.i = getelementptr i8, ptr %arg.J.4, i64 %.pre-phi.i
  %.1349.i = load double, ptr %16, align 8, !noalias !0
  %.1353.i = fmul double %.6041062.i, %.1349.i
  %scevgep5.i = getelementptr i8, ptr %gep1124.peel.i, i64 %.pre-phi.i
  store double %.1353.i, ptr %scevgep5.i, align 8, !noalias !0
  store double %.1407.i, ptr %scevgep1.i, align 8, !noalias !0
  %.1348.1.i = getelementptr i8, ptr %16, i64 8
  %.1349.1.i = load double, ptr %.1348.1.i, align 8, !noalias !0
  %.1353.1.i = fmul double %.6041062.i, %.1349.1.i
  %.1407.1.i = load double, ptr %.1406.1.peel.i, align 8, !noalias !0
  %scevgep19.i = getelementptr i8, ptr %gep1124.1.peel.i, i64 %.pre-phi.i
  store double %.1353.1.i, ptr %scevgep19.i, align 8, !noalias !0
  %scevgep22.i = getelementptr i8, ptr %scevgep13.i, i64 %.pre-phi.i
  store double %.1407.1.i, ptr %scevgep22.i, align 8, !noalias !0
  %.1348.2.i = getelementptr i8, ptr %16, i64 16
  %.1349.2.i = load double, ptr %.1348.2.i, align 8, !noalias !0
  %.1353.2.i = fmul double %.6041062.i, %.1349.2.i
  %.1407.2.i = load double, ptr %9, align 8, !noalias !0
  %scevgep23.i = getelementptr i8, ptr %gep1124.2.peel.i, i64 %.pre-phi.i
  store double %.1353.2.i, ptr %scevgep23.i, align 8, !noalias !0
  %scevgep26.i = getelementptr i8, ptr %gep1126.2.peel.i, i64 %.pre-phi.i
  store double %.1407.2.i, ptr %scevgep26.i, align 8, !noalias !0
  %.1025.i = tail call double @llvm.cos.f64(double %.1024.i)
  %.1057.i = tail call double @llvm.sin.f64(double %.1024.i)
  %.1692.i = mul i64 %spec.select1098.i, %arg.frame.5.1
  %17 = getelementptr double, ptr %arg.frame.4, i64 %.1692.i
  %.1747.i = mul nuw nsw i64 %spec.select1097.i, %arg.frame.5.1
  %18 = getelementptr double, ptr %arg.frame.4, i64 %.1747.i
  %.1759.i = fmul double %.6041062.i, %.1057.i
  %.1697.i = load double, ptr %17, align 8, !noalias !0
  %.1752.i = load double, ptr %18, align 8, !noalias !0
  %.1756.i = fmul double %.1025.i, %.1697.i
  %.1760.i = fmul double %.1759.i, %.1752.i
  %.1761.i = fadd double %.1756.i, %.1760.i
  %.1763.i = fmul double %.1025.i, %.1752.i
  %.1767.i = fmul double %.1759.i, %.1697.i
  %.1768.i = fsub double %.1763.i, %.1767.i
  store double %.1761.i, ptr %17, align 8, !noalias !0
  store double %.1768.i, ptr %18, align 8, !noalias !0
  %.1696.1.i = getelementptr i8, ptr %17, i64 8
  %.1697.1.i = load double, ptr %.1696.1.i, align 8, !noalias !0
  %.1751.1.i = getelementptr i8, ptr %18, i64 8
  %.1752.1.i = load double, ptr %.1751.1.i, align 8, !noalias !0
  %.1756.1.i = fmul double %.1025.i, %.1697.1.i
  %.1760.1.i = fmul double %.1759.i, %.1752.1.i
  %.1761.1.i = fadd double %.1756.1.i, %.1760.1.i
  %.1763.1.i = fmul double %.1025.i, %.1752.1.i
  %.1767.1.i = fmul double %.1759.i, %.1697.1.i
  %.1768.1.i = fsub double %.1763.1.i, %.1767.1.i
  store double %.1761.1.i, ptr %.1696.1.i, align 8, !noalias !0
  store double %.1768.1.i, ptr %.1751.1.i, align 8, !noalias !0
  %.1696.2.i = getelementptr i8, ptr %17, i64 16
  %.1697.2.i = load double, ptr %.1696.2.i, align 8, !noalias !0
  %.1751.2.i = getelementptr i8, ptr %18, i64 16
  %.1752.2.i = load double, ptr %.1751.2.i, align 8, !noalias !0
  %.1756.2.i = fmul double %.1025.i, %.1697.2.i
  %.1760.2.i = fmul double %.1759.i, %.1752.2.i
  %.1761.2.i = fadd double %.1756.2.i, %.1760.2.i
  %.1763.2.i = fmul double %.1025.i, %.1752.2.i
  %.1767.2.i = fmul double %.1759.i, %.1697.2.i
  %.1768.2.i = fsub double %.1763.2.i, %.1767.2.i
  store double %.1761.2.i, ptr %.1696.2.i, align 8, !noalias !0
  store double %.1768.2.i, ptr %.1751.2.i, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.575.i, 7
  br i1 %exitcond.not.i, label %part.0, label %B162.i, !llvm.loop !3

part.0: ; preds = %B322.else.if.i
  %.2103.i = getelementptr i8, ptr %arg.arm.4, i64 24
  %.2188.i = getelementptr i8, ptr %arg.arm.4, i64 32
  %.2274.i = getelementptr i8, ptr %arg.arm.4, i64 40
  %.2074.i = load double, ptr %8, align 8, !noalias !0
  %.2104.i = load double, ptr %.2103.i, align 8, !noalias !0
  %.2158.i = load double, ptr %arg.frame.4, align 8, !noalias !0
  %.2159.i = fmul double %.2104.i, %.2158.i
  %.2189.i = load double, ptr %.2188.i, align 8, !noalias !0
  %sunkaddr22.i = shl i64 %arg.frame.5.1, 3
  %sunkaddr23.i = getelementptr i8, ptr %arg.frame.4, i64 %sunkaddr22.i
  %.2243.i = load double, ptr %sunkaddr23.i, align 8, !noalias !0
  %.2244.i = fmul double %.2189.i, %.2243.i
  %.2245.i = fadd double %.2159.i, %.2244.i
  %.2275.i = load double, ptr %.2274.i, align 8, !noalias !0
  %.2329.i = load double, ptr %5, align 8, !noalias !0
  %.2330.i = fmul double %.2275.i, %.2329.i
  %.2331.i = fadd double %.2245.i, %.2330.i
  %.2332.i = fadd double %.2074.i, %.2331.i
  store double %.2332.i, ptr %8, align 8, !noalias !0
  %.2074.1.i = load double, ptr %.1406.1.peel.i, align 8, !noalias !0
  %.2104.1.i = load double, ptr %.2103.i, align 8, !noalias !0
  %.2158.1.i = load double, ptr %0, align 8, !noalias !0
  %.2159.1.i = fmul double %.2104.1.i, %.2158.1.i
  %.2189.1.i = load double, ptr %.2188.i, align 8, !noalias !0
  %sunkaddr28.i = getelementptr i8, ptr %sunkaddr23.i, i64 8
  %.2243.1.i = load double, ptr %sunkaddr28.i, align 8, !noalias !0
  %.2244.1.i = fmul double %.2189.1.i, %.2243.1.i
  %.2245.1.i = fadd double %.2159.1.i, %.2244.1.i
  %.2275.1.i = load double, ptr %.2274.i, align 8, !noalias !0
  %.2329.1.i = load double, ptr %6, align 8, !noalias !0
  %.2330.1.i = fmul double %.2275.1.i, %.2329.1.i
  %.2331.1.i = fadd double %.2245.1.i, %.2330.1.i
  %.2332.1.i = fadd double %.2074.1.i, %.2331.1.i
  store double %.2332.1.i, ptr %.1406.1.peel.i, align 8, !noalias !0
  %.2074.2.i = load double, ptr %9, align 8, !noalias !0
  %.2104.2.i = load double, ptr %.2103.i, align 8, !noalias !0
  %.2158.2.i = load double, ptr %1, align 8, !noalias !0
  %.2159.2.i = fmul double %.2104.2.i, %.2158.2.i
  %.2189.2.i = load double, ptr %.2188.i, align 8, !noalias !0
  %sunkaddr34.i = getelementptr i8, ptr %sunkaddr23.i, i64 16
  %.2243.2.i = load double, ptr %sunkaddr34.i, align 8, !noalias !0
  %.2244.2.i = fmul double %.2189.2.i, %.2243.2.i
  %.2245.2.i = fadd double %.2159.2.i, %.2244.2.i
  %.2275.2.i = load double, ptr %.2274.i, align 8, !noalias !0
  %.2329.2.i = load double, ptr %7, align 8, !noalias !0
  %.2330.2.i = fmul double %.2275.2.i, %.2329.2.i
  %.2331.2.i = fadd double %.2245.2.i, %.2330.2.i
  %.2332.2.i = fadd double %.2074.2.i, %.2331.2.i
  store double %.2332.2.i, ptr %9, align 8, !noalias !0
  %.2619.i = load double, ptr %arg.J.4, align 8, !noalias !0
  %.2620.i = fsub double %.2332.i, %.2619.i
  %.2728.i = load double, ptr %scevgep13.i, align 8, !noalias !0
  %.2729.i = fsub double %.2332.1.i, %.2728.i
  %.2837.i = load double, ptr %gep1126.2.peel.i, align 8, !noalias !0
  %.2838.i = fsub double %.2332.2.i, %.2837.i
  %.2892.i = load double, ptr %gep1124.peel.i, align 8, !noalias !0
  %.2946.i = load double, ptr %gep1124.1.peel.i, align 8, !noalias !0
  %.3000.i = load double, ptr %gep1124.2.peel.i, align 8, !noalias !0
  %.3001.i = fmul double %.2838.i, %.2946.i
  %.3002.i = fmul double %.2729.i, %.3000.i
  %.3003.i = fsub double %.3001.i, %.3002.i
  %.3004.i = fmul double %.2620.i, %.3000.i
  %.3005.i = fmul double %.2892.i, %.2838.i
  %.3006.i = fsub double %.3004.i, %.3005.i
  %.3007.i = fmul double %.2729.i, %.2892.i
  %.3008.i = fmul double %.2620.i, %.2946.i
  %.3009.i = fsub double %.3007.i, %.3008.i
  store double %.3003.i, ptr %arg.J.4, align 8, !noalias !0
  store double %.3006.i, ptr %scevgep13.i, align 8, !noalias !0
  store double %.3009.i, ptr %gep1126.2.peel.i, align 8, !noalias !0
  %.2565.1.i = load double, ptr %8, align 8, !noalias !0
  %.2618.1.i = getelementptr i8, ptr %arg.J.4, i64 8
  %.2619.1.i = load double, ptr %.2618.1.i, align 8, !noalias !0
  %.2620.1.i = fsub double %.2565.1.i, %.2619.1.i
  %.2674.1.i = load double, ptr %.1406.1.peel.i, align 8, !noalias !0
  %sunkaddr40.i = getelementptr i8, ptr %scevgep13.i, i64 8
  %.2728.1.i = load double, ptr %sunkaddr40.i, align 8, !noalias !0
  %.2729.1.i = fsub double %.2674.1.i, %.2728.1.i
  %.2783.1.i = load double, ptr %9, align 8, !noalias !0
  %.2836.1.i = getelementptr i8, ptr %gep1126.2.peel.i, i64 8
  %.2837.1.i = load double, ptr %.2836.1.i, align 8, !noalias !0
  %.2838.1.i = fsub double %.2783.1.i, %.2837.1.i
  %.2891.1.i = getelementptr i8, ptr %gep1124.peel.i, i64 8
  %.2892.1.i = load double, ptr %.2891.1.i, align 8, !noalias !0
  %.2945.1.i = getelementptr i8, ptr %gep1124.1.peel.i, i64 8
  %.2946.1.i = load double, ptr %.2945.1.i, align 8, !noalias !0
  %.2999.1.i = getelementptr i8, ptr %gep1124.2.peel.i, i64 8
  %.3000.1.i = load double, ptr %.2999.1.i, align 8, !noalias !0
  %.3001.1.i = fmul double %.2838.1.i, %.2946.1.i
  %.3002.1.i = fmul double %.2729.1.i, %.3000.1.i
  %.3003.1.i = fsub double %.3001.1.i, %.3002.1.i
  %.3004.1.i = fmul double %.2620.1.i, %.3000.1.i
  %.3005.1.i = fmul double %.2892.1.i, %.2838.1.i
  %.3006.1.i = fsub double %.3004.1.i, %.3005.1.i
  %.3007.1.i = fmul double %.2729.1.i, %.2892.1.i
  %.3008.1.i = fmul double %.2620.1.i, %.2946.1.i
  %.3009.1.i = fsub double %.3007.1.i, %.3008.1.i
  store double %.3003.1.i, ptr %.2618.1.i, align 8, !noalias !0
  store double %.3006.1.i, ptr %sunkaddr40.i, align 8, !noalias !0
  store double %.3009.1.i, ptr %.2836.1.i, align 8, !noalias !0
  %.2565.2.i = load double, ptr %8, align 8, !noalias !0
  %.2618.2.i = getelementptr i8, ptr %arg.J.4, i64 16
  %.2619.2.i = load double, ptr %.2618.2.i, align 8, !noalias !0
  %.2620.2.i = fsub double %.2565.2.i, %.2619.2.i
  %.2674.2.i = load double, ptr %.1406.1.peel.i, align 8, !noalias !0
  %sunkaddr43.i = getelementptr i8, ptr %scevgep13.i, i64 16
  %.2728.2.i = load double, ptr %sunkaddr43.i, align 8, !noalias !0
  %.2729.2.i = fsub double %.2674.2.i, %.2728.2.i
  %.2783.2.i = load double, ptr %9, align 8, !noalias !0
  %.2836.2.i = getelementptr i8, ptr %gep1126.2.peel.i, i64 16
  %.2837.2.i = load double, ptr %.2836.2.i, align 8, !noalias !0
  %.2838.2.i = fsub double %.2783.2.i, %.2837.2.i
  %.2891.2.i = getelementptr i8, ptr %gep1124.peel.i, i64 16
  %.2892.2.i = load double, ptr %.2891.2.i, align 8, !noalias !0
  %.2945.2.i = getelementptr i8, ptr %gep1124.1.peel.i, i64 16
  %.2946.2.i = load double, ptr %.2945.2.i, align 8, !noalias !0
  %.2999.2.i = getelementptr i8, ptr %gep1124.2.peel.i, i64 16
  %.3000.2.i = load double, ptr %.2999.2.i, align 8, !noalias !0
  %.3001.2.i = fmul double %.2838.2.i, %.2946.2.i
  %.3002.2.i = fmul double %.2729.2.i, %.3000.2.i
  %.3003.2.i = fsub double %.3001.2.i, %.3002.2.i
  %.3004.2.i = fmul double %.2620.2.i, %.3000.2.i
  %.3005.2.i = fmul double %.2892.2.i, %.2838.2.i
  %.3006.2.i = fsub double %.3004.2.i, %.3005.2.i
  %.3007.2.i = fmul double %.2729.2.i, %.2892.2.i
  %.3008.2.i = fmul double %.2620.2.i, %.2946.2.i
  %.3009.2.i = fsub double %.3007.2.i, %.3008.2.i
  store double %.3003.2.i, ptr %.2618.2.i, align 8, !noalias !0
  store double %.3006.2.i, ptr %sunkaddr43.i, align 8, !noalias !0
  store double %.3009.2.i, ptr %.2836.2.i, align 8, !noalias !0
  %.2565.3.i = load double, ptr %8, align 8, !noalias !0
  %.2618.3.i = getelementptr i8, ptr %arg.J.4, i64 24
  %.2619.3.i = load double, ptr %.2618.3.i, align 8, !noalias !0
  %.2620.3.i = fsub double %.2565.3.i, %.2619.3.i
  %.2674.3.i = load double, ptr %.1406.1.peel.i, align 8, !noalias !0
  %sunkaddr46.i = getelementptr i8, ptr %scevgep13.i, i64 24
  %.2728.3.i = load double, ptr %sunkaddr46.i, align 8, !noalias !0
  %.2729.3.i = fsub double %.2674.3.i, %.2728.3.i
  %.2783.3.i = load double, ptr %9, align 8, !noalias !0
  %.2836.3.i = getelementptr i8, ptr %gep1126.2.peel.i, i64 24
  %.2837.3.i = load double, ptr %.2836.3.i, align 8, !noalias !0
  %.2838.3.i = fsub double %.2783.3.i, %.2837.3.i
  %.2891.3.i = getelementptr i8, ptr %gep1124.peel.i, i64 24
  %.2892.3.i = load double, ptr %.2891.3.i, align 8, !noalias !0
  %.2945.3.i = getelementptr i8, ptr %gep1124.1.peel.i, i64 24
  %.2946.3.i = load double, ptr %.2945.3.i, align 8, !noalias !0
  %.2999.3.i = getelementptr i8, ptr %gep1124.2.peel.i, i64 24
  %.3000.3.i = load double, ptr %.2999.3.i, align 8, !noalias !0
  %.3001.3.i = fmul double %.2838.3.i, %.2946.3.i
  %.3002.3.i = fmul double %.2729.3.i, %.3000.3.i
  %.3003.3.i = fsub double %.3001.3.i, %.3002.3.i
  %.3004.3.i = fmul double %.2620.3.i, %.3000.3.i
  %.3005.3.i = fmul double %.2892.3.i, %.2838.3.i
  %.3006.3.i = fsub double %.3004.3.i, %.3005.3.i
  %.3007.3.i = fmul double %.2729.3.i, %.2892.3.i
  %.3008.3.i = fmul double %.2620.3.i, %.2946.3.i
  %.3009.3.i = fsub double %.3007.3.i, %.3008.3.i
  store double %.3003.3.i, ptr %.2618.3.i, align 8, !noalias !0
  store double %.3006.3.i, ptr %sunkaddr46.i, align 8, !noalias !0
  store double %.3009.3.i, ptr %.2836.3.i, align 8, !noalias !0
  %.2565.4.i = load double, ptr %8, align 8, !noalias !0
  %.2618.4.i = getelementptr i8, ptr %arg.J.4, i64 32
  %.2619.4.i = load double, ptr %.2618.4.i, align 8, !noalias !0
  %.2620.4.i = fsub double %.2565.4.i, %.2619.4.i
  %.2674.4.i = load double, ptr %.1406.1.peel.i, align 8, !noalias !0
  %sunkaddr49.i = getelementptr i8, ptr %scevgep13.i, i64 32
  %.2728.4.i = load double, ptr %sunkaddr49.i, align 8, !noalias !0
  %.2729.4.i = fsub double %.2674.4.i, %.2728.4.i
  %.2783.4.i = load double, ptr %9, align 8, !noalias !0
  %.2836.4.i = getelementptr i8, ptr %gep1126.2.peel.i, i64 32
  %.2837.4.i = load double, ptr %.2836.4.i, align 8, !noalias !0
  %.2838.4.i = fsub double %.2783.4.i, %.2837.4.i
  %.2891.4.i = getelementptr i8, ptr %gep1124.peel.i, i64 32
  %.2892.4.i = load double, ptr %.2891.4.i, align 8, !noalias !0
  %.2945.4.i = getelementptr i8, ptr %gep1124.1.peel.i, i64 32
  %.2946.4.i = load double, ptr %.2945.4.i, align 8, !noalias !0
  %.2999.4.i = getelementptr i8, ptr %gep1124.2.peel.i, i64 32
  %.3000.4.i = load double, ptr %.2999.4.i, align 8, !noalias !0
  %.3001.4.i = fmul double %.2838.4.i, %.2946.4.i
  %.3002.4.i = fmul double %.2729.4.i, %.3000.4.i
  %.3003.4.i = fsub double %.3001.4.i, %.3002.4.i
  %.3004.4.i = fmul double %.2620.4.i, %.3000.4.i
  %.3005.4.i = fmul double %.2892.4.i, %.2838.4.i
  %.3006.4.i = fsub double %.3004.4.i, %.3005.4.i
  %.3007.4.i = fmul double %.2729.4.i, %.2892.4.i
  %.3008.4.i = fmul double %.2620.4.i, %.2946.4.i
  %.3009.4.i = fsub double %.3007.4.i, %.3008.4.i
  store double %.3003.4.i, ptr %.2618.4.i, align 8, !noalias !0
  store double %.3006.4.i, ptr %sunkaddr49.i, align 8, !noalias !0
  store double %.3009.4.i, ptr %.2836.4.i, align 8, !noalias !0
  %.2565.5.i = load double, ptr %8, align 8, !noalias !0
  %.2618.5.i = getelementptr i8, ptr %arg.J.4, i64 40
  %.2619.5.i = load double, ptr %.2618.5.i, align 8, !noalias !0
  %.2620.5.i = fsub double %.2565.5.i, %.2619.5.i
  %.2674.5.i = load double, ptr %.1406.1.peel.i, align 8, !noalias !0
  %sunkaddr52.i = getelementptr i8, ptr %scevgep13.i, i64 40
  %.2728.5.i = load double, ptr %sunkaddr52.i, align 8, !noalias !0
  %.2729.5.i = fsub double %.2674.5.i, %.2728.5.i
  %.2783.5.i = load double, ptr %9, align 8, !noalias !0
  %.2836.5.i = getelementptr i8, ptr %gep1126.2.peel.i, i64 40
  %.2837.5.i = load double, ptr %.2836.5.i, align 8, !noalias !0
  %.2838.5.i = fsub double %.2783.5.i, %.2837.5.i
  %.2891.5.i = getelementptr i8, ptr %gep1124.peel.i, i64 40
  %.2892.5.i = load double, ptr %.2891.5.i, align 8, !noalias !0
  %.2945.5.i = getelementptr i8, ptr %gep1124.1.peel.i, i64 40
  %.2946.5.i = load double, ptr %.2945.5.i, align 8, !noalias !0
  %.2999.5.i = getelementptr i8, ptr %gep1124.2.peel.i, i64 40
  %.3000.5.i = load double, ptr %.2999.5.i, align 8, !noalias !0
  %.3001.5.i = fmul double %.2838.5.i, %.2946.5.i
  %.3002.5.i = fmul double %.2729.5.i, %.3000.5.i
  %.3003.5.i = fsub double %.3001.5.i, %.3002.5.i
  %.3004.5.i = fmul double %.2620.5.i, %.3000.5.i
  %.3005.5.i = fmul double %.2892.5.i, %.2838.5.i
  %.3006.5.i = fsub double %.3004.5.i, %.3005.5.i
  %.3007.5.i = fmul double %.2729.5.i, %.2892.5.i
  %.3008.5.i = fmul double %.2620.5.i, %.2946.5.i
  %.3009.5.i = fsub double %.3007.5.i, %.3008.5.i
  store double %.3003.5.i, ptr %.2618.5.i, align 8, !noalias !0
  store double %.3006.5.i, ptr %sunkaddr52.i, align 8, !noalias !0
  store double %.3009.5.i, ptr %.2836.5.i, align 8, !noalias !0
  %.2565.6.i = load double, ptr %8, align 8, !noalias !0
  %.2618.6.i = getelementptr i8, ptr %arg.J.4, i64 48
  %.2619.6.i = load double, ptr %.2618.6.i, align 8, !noalias !0
  %.2620.6.i = fsub double %.2565.6.i, %.2619.6.i
  %.2674.6.i = load double, ptr %.1406.1.peel.i, align 8, !noalias !0
  %sunkaddr55.i = getelementptr i8, ptr %scevgep13.i, i64 48
  %.2728.6.i = load double, ptr %sunkaddr55.i, align 8, !noalias !0
  %.2729.6.i = fsub double %.2674.6.i, %.2728.6.i
  %.2783.6.i = load double, ptr %9, align 8, !noalias !0
  %.2836.6.i = getelementptr i8, ptr %gep1126.2.peel.i, i64 48
  %.2837.6.i = load double, ptr %.2836.6.i, align 8, !noalias !0
  %.2838.6.i = fsub double %.2783.6.i, %.2837.6.i
  %.2891.6.i = getelementptr i8, ptr %gep1124.peel.i, i64 48
  %.2892.6.i = load double, ptr %.2891.6.i, align 8, !noalias !0
  %.2945.6.i = getelementptr i8, ptr %gep1124.1.peel.i, i64 48
  %.2946.6.i = load double, ptr %.2945.6.i, align 8, !noalias !0
  %.2999.6.i = getelementptr i8, ptr %gep1124.2.peel.i, i64 48
  %.3000.6.i = load double, ptr %.2999.6.i, align 8, !noalias !0
  %.3001.6.i = fmul double %.2838.6.i, %.2946.6.i
  %.3002.6.i = fmul double %.2729.6.i, %.3000.6.i
  %.3003.6.i = fsub double %.3001.6.i, %.3002.6.i
  %.3004.6.i = fmul double %.2620.6.i, %.3000.6.i
  %.3005.6.i = fmul double %.2892.6.i, %.2838.6.i
  %.3006.6.i = fsub double %.3004.6.i, %.3005.6.i
  %.3007.6.i = fmul double %.2729.6.i, %.2892.6.i
  %.3008.6.i = fmul double %.2620.6.i, %.2946.6.i
  %.3009.6.i = fsub double %.3007.6.i, %.3008.6.i
  store double %.3003.6.i, ptr %.2618.6.i, align 8, !noalias !0
  store double %.3006.6.i, ptr %sunkaddr55.i, align 8, !noalias !0
  store double %.3009.6.i, ptr %.2836.6.i, align 8, !noalias !0
  %.193 = getelementptr i8, ptr %arg.out.4, i64 48
  store double 0.000000e+00, ptr %.193, align 8
  %19 = shl i64 %arg.L.5.1, 4
  %20 = getelementptr i8, ptr %arg.L.4, i64 %19
  %scevgep = getelementptr i8, ptr %20, i64 32
  %21 = shl i64 %arg.L.5.1, 3
  %scevgep295 = getelementptr i8, ptr %20, i64 16
  %scevgep298 = getelementptr i8, ptr %arg.L.4, i64 16
  %sunkaddr349 = getelementptr i8, ptr %arg.tau.4, i64 8
  %sunkaddr350 = getelementptr i8, ptr %arg.tau.4, i64 16
  %sunkaddr351 = getelementptr i8, ptr %arg.tau.4, i64 24
  %sunkaddr352 = getelementptr i8, ptr %arg.tau.4, i64 32
  %sunkaddr353 = getelementptr i8, ptr %arg.tau.4, i64 40
  %sunkaddr354 = getelementptr i8, ptr %arg.tau.4, i64 48
  %sunkaddr408 = getelementptr i8, ptr %arg.L.4, i64 %21
  %sunkaddr413 = getelementptr i8, ptr %sunkaddr408, i64 8
  %sunkaddr325 = getelementptr i8, ptr %arg.out.4, i64 8
  %sunkaddr331 = getelementptr i8, ptr %arg.out.4, i64 16
  %sunkaddr337 = getelementptr i8, ptr %arg.out.4, i64 24
  %sunkaddr343 = getelementptr i8, ptr %arg.out.4, i64 32
  %scevgep309.peel = getelementptr i8, ptr %gep1126.2.peel.i, i64 8
  %scevgep308.peel = getelementptr i8, ptr %gep1126.2.peel.i, i64 16
  %scevgep307.peel = getelementptr i8, ptr %gep1126.2.peel.i, i64 24
  %scevgep306.peel = getelementptr i8, ptr %gep1126.2.peel.i, i64 32
  %scevgep305.peel = getelementptr i8, ptr %gep1126.2.peel.i, i64 40
  %scevgep293.peel = getelementptr i8, ptr %20, i64 8
  %sunkaddr44344 = getelementptr i8, ptr %arg.out.4, i64 16
  %lsr.iv289.peel = getelementptr i8, ptr %scevgep, i64 %21
  %.pn.peel = getelementptr i8, ptr %scevgep295, i64 %21
  %lsr.iv296.peel = getelementptr i8, ptr %.pn.peel, i64 8
  %lsr.iv303.peel = getelementptr i8, ptr %.2836.6.i, i64 %10
  %scevgep310.peel = getelementptr i8, ptr %lsr.iv303.peel, i64 -48
  %scevgep309.peel57 = getelementptr i8, ptr %lsr.iv303.peel, i64 -40
  %scevgep308.peel62 = getelementptr i8, ptr %lsr.iv303.peel, i64 -32
  %scevgep307.peel67 = getelementptr i8, ptr %lsr.iv303.peel, i64 -24
  %scevgep306.peel72 = getelementptr i8, ptr %lsr.iv303.peel, i64 -16
  %scevgep305.peel77 = getelementptr i8, ptr %lsr.iv303.peel, i64 -8
  %scevgep294.peel = getelementptr i8, ptr %lsr.iv289.peel, i64 -32
  %scevgep293.peel90 = getelementptr i8, ptr %lsr.iv289.peel, i64 -24
  %scevgep292.peel = getelementptr i8, ptr %lsr.iv289.peel, i64 -16
  br label %B236.endif.endif.lr.ph

B358.2:                                           ; preds = %B1427.peel103, %B1427
  %lsr.iv303.pn = phi ptr [ %lsr.iv303, %B1427 ], [ %lsr.iv303.peel, %B1427.peel103 ]
  %22 = phi ptr [ %.pn, %B1427 ], [ %.pn.peel, %B1427.peel103 ]
  %lsr.iv289.pn = phi ptr [ %lsr.iv289, %B1427 ], [ %lsr.iv289.peel, %B1427.peel103 ]
  %lsr.iv = phi i64 [ %lsr.iv.next, %B1427 ], [ 2, %B1427.peel103 ]
  %23 = getelementptr i8, ptr %22, i64 8
  %lsr.iv289 = getelementptr i8, ptr %lsr.iv289.pn, i64 %21
  %.pn = getelementptr i8, ptr %23, i64 %21
  %lsr.iv296 = getelementptr i8, ptr %.pn, i64 8
  %lsr.iv303 = getelementptr i8, ptr %lsr.iv303.pn, i64 %10
  %24 = add i64 %lsr.iv, 2
  %.912 = load double, ptr %sunkaddr366, align 8
  %scevgep310 = getelementptr i8, ptr %lsr.iv303, i64 -48
  %.967 = load double, ptr %scevgep310, align 8
  %.970 = fmul double %.912, %.967
  %.972 = fadd double %.970, 0.000000e+00
  %.912.1 = load double, ptr %sunkaddr371, align 8
  %scevgep309 = getelementptr i8, ptr %lsr.iv303, i64 -40
  %.967.1 = load double, ptr %scevgep309, align 8
  %.970.1 = fmul double %.912.1, %.967.1
  %.972.1 = fadd double %.972, %.970.1
  %.912.2 = load double, ptr %sunkaddr377, align 8
  %scevgep308 = getelementptr i8, ptr %lsr.iv303, i64 -32
  %.967.2 = load double, ptr %scevgep308, align 8
  %.970.2 = fmul double %.912.2, %.967.2
  %.972.2 = fadd double %.972.1, %.970.2
  %.912.3 = load double, ptr %sunkaddr383, align 8
  %scevgep307 = getelementptr i8, ptr %lsr.iv303, i64 -24
  %.967.3 = load double, ptr %scevgep307, align 8
  %.970.3 = fmul double %.912.3, %.967.3
  %.972.3 = fadd double %.972.2, %.970.3
  %.912.4 = load double, ptr %sunkaddr389, align 8
  %scevgep306 = getelementptr i8, ptr %lsr.iv303, i64 -16
  %.967.4 = load double, ptr %scevgep306, align 8
  %.970.4 = fmul double %.912.4, %.967.4
  %.972.4 = fadd double %.972.3, %.970.4
  %.912.5 = load double, ptr %sunkaddr395, align 8
  %scevgep305 = getelementptr i8, ptr %lsr.iv303, i64 -8
  %.967.5 = load double, ptr %scevgep305, align 8
  %.970.5 = fmul double %.912.5, %.967.5
  %.972.5 = fadd double %.972.4, %.970.5
  %.912.6 = load double, ptr %sunkaddr401, align 8
  %.967.6 = load double, ptr %lsr.iv303, align 8
  %.970.6 = fmul double %.912.6, %.967.6
  %.972.6 = fadd double %.972.5, %.970.6
  %.1156 = load double, ptr %sunkaddr406, align 8
  %scevgep294 = getelementptr i8, ptr %lsr.iv289, i64 -32
  %.1211 = load double, ptr %scevgep294, align 8
  %.1214 = fmul double %.1156, %.1211
  %.1216 = fsub double %.972.6, %.1214
  %.1156.1 = load double, ptr %sunkaddr441, align 8
  %scevgep293 = getelementptr i8, ptr %lsr.iv289, i64 -24
  %.1211.1 = load double, ptr %scevgep293, align 8
  %.1214.1 = fmul double %.1156.1, %.1211.1
  %.1216.1 = fsub double %.1216, %.1214.1
  %.1156.2 = load double, ptr %sunkaddr312, align 8
  %scevgep292 = getelementptr i8, ptr %lsr.iv289, i64 -16
  %.1211.2 = load double, ptr %scevgep292, align 8
  %.1214.2 = fmul double %.1156.2, %.1211.2
  %.1216.2 = fsub double %.1216.1, %.1214.2
  %.1156.3 = load double, ptr %sunkaddr315, align 8
  %scevgep291 = getelementptr i8, ptr %lsr.iv289, i64 -8
  %.1211.3 = load double, ptr %scevgep291, align 8
  %.1214.3 = fmul double %.1156.3, %.1211.3
  %.1216.3 = fsub double %.1216.2, %.1214.3
  %exitcond.not.3 = icmp eq i64 %lsr.iv, 2
  br i1 %exitcond.not.3, label %B410, label %B358.4

B358.4:                                           ; preds = %B358.2
  %.1156.4 = load double, ptr %sunkaddr318, align 8
  %.1211.4 = load double, ptr %lsr.iv289, align 8
  %.1214.4 = fmul double %.1156.4, %.1211.4
  %.1216.4 = fsub double %.1216.3, %.1214.4
  br label %B410

B410:                                             ; preds = %B358.4, %B358.2
  %.1216.lcssa = phi double [ %.1216.4, %B358.4 ], [ %.1216.3, %B358.2 ]
  %.1226 = icmp samesign ult i64 %24, %.28113841413
  br i1 %.1226, label %B422, label %B460

B422:                                             ; preds = %B410
  %.1281 = load double, ptr %lsr.iv296, align 8
  %.1288 = fdiv double %.1216.lcssa, %.1281
  %25 = shl i64 %lsr.iv, 3
  %scevgep301 = getelementptr i8, ptr %lsr.iv299, i64 %25
  store double %.1288, ptr %scevgep301, align 8
  br label %B1427

B460:                                             ; preds = %B410
  %.1353 = fcmp ogt double %.1216.lcssa, 0.000000e+00
  br i1 %.1353, label %B500, label %B472

common.ret.sink.split:                            ; preds = %B1000.5, %B472
  store ptr null, ptr %retptr, align 8
  ret i32 0

B472:                                             ; preds = %B460.peel274, %B460.peel, %B460.peel31, %B460, %B460.peel96
  store double 0x7FF0000000000000, ptr %.193, align 8
  br label %common.ret.sink.split

B500:                                             ; preds = %B460
  %.1425 = tail call double @sqrt(double %.1216.lcssa)
  store double %.1425, ptr %sunkaddr321, align 8
  br label %B1427

B574.1:                                           ; preds = %B574.preheader
  %sunkaddr324 = getelementptr i8, ptr %sunkaddr445, i64 8
  %.1690.1 = load double, ptr %sunkaddr324, align 8
  %.1722.1 = load double, ptr %sunkaddr325, align 8
  %.1723.1 = fmul double %.1690.1, %.1722.1
  %.1724.1 = fsub double %.1724, %.1723.1
  store double %.1724.1, ptr %sunkaddr44346, align 8
  %exitcond1518.not.1 = icmp eq i64 %.28113841413, 2
  br i1 %exitcond1518.not.1, label %B644, label %B574.2

B574.2:                                           ; preds = %B574.1
  %sunkaddr330 = getelementptr i8, ptr %sunkaddr445, i64 16
  %.1690.2 = load double, ptr %sunkaddr330, align 8
  %.1722.2 = load double, ptr %sunkaddr331, align 8
  %.1723.2 = fmul double %.1690.2, %.1722.2
  %.1724.2 = fsub double %.1724.1, %.1723.2
  store double %.1724.2, ptr %sunkaddr44346, align 8
  %exitcond1518.not.2 = icmp eq i64 %.28113841413, 3
  br i1 %exitcond1518.not.2, label %B644, label %B574.3

B574.3:                                           ; preds = %B574.2
  %sunkaddr336 = getelementptr i8, ptr %sunkaddr445, i64 24
  %.1690.3 = load double, ptr %sunkaddr336, align 8
  %.1722.3 = load double, ptr %sunkaddr337, align 8
  %.1723.3 = fmul double %.1690.3, %.1722.3
  %.1724.3 = fsub double %.1724.2, %.1723.3
  store double %.1724.3, ptr %sunkaddr44346, align 8
  %exitcond1518.not.3 = icmp eq i64 %.28113841413, 4
  br i1 %exitcond1518.not.3, label %B644, label %B574.4

B574.4:                                           ; preds = %B574.3
  %sunkaddr342 = getelementptr i8, ptr %sunkaddr445, i64 32
  %.1690.4 = load double, ptr %sunkaddr342, align 8
  %.1722.4 = load double, ptr %sunkaddr343, align 8
  %.1723.4 = fmul double %.1690.4, %.1722.4
  %.1724.4 = fsub double %.1724.3, %.1723.4
  store double %.1724.4, ptr %sunkaddr44346, align 8
  br label %B644

B644:                                             ; preds = %B574.preheader, %B542.endif, %B574.4, %B574.3, %B574.2, %B574.1
  %sunkaddr44347 = phi ptr [ %sunkaddr443, %B542.endif ], [ %sunkaddr44346, %B574.4 ], [ %sunkaddr44346, %B574.3 ], [ %sunkaddr44346, %B574.2 ], [ %sunkaddr44346, %B574.1 ], [ %sunkaddr44346, %B574.preheader ]
  %.1840.pre-phi = phi i64 [ 0, %B542.endif ], [ %.1151, %B574.4 ], [ %.1151, %B574.3 ], [ %.1151, %B574.2 ], [ %.1151, %B574.1 ], [ %.1151, %B574.preheader ]
  %.1791 = phi double [ %.1791.pre.pre, %B542.endif ], [ %.1724.4, %B574.4 ], [ %.1724.3, %B574.3 ], [ %.1724.2, %B574.2 ], [ %.1724.1, %B574.1 ], [ %.1724, %B574.preheader ]
  %26 = getelementptr double, ptr %arg.L.4, i64 %.1840.pre-phi
  %27 = getelementptr double, ptr %26, i64 %.28113841413
  %.1845 = load double, ptr %27, align 8
  %.1851 = fdiv double %.1791, %.1845
  store double %.1851, ptr %sunkaddr44347, align 8
  %indvars.iv.next = add nuw nsw i64 %indvars.iv, 1
  %scevgep300 = getelementptr i8, ptr %lsr.iv299, i64 %21
  %exitcond1519.not = icmp eq i64 %.288, 6
  br i1 %exitcond1519.not, label %B1000.5, label %B236.endif.endif.lr.ph

B1000.5:                                          ; preds = %B644
  %.2550.pre = load double, ptr %arg.L.4, align 8
  %.2557 = fdiv double 1.000000e+00, %.2550.pre
  %.2592 = load double, ptr %.193, align 8
  %.2595 = fmul double %.2557, %.2557
  %.2596 = fadd double %.2592, %.2595
  store double %.2596, ptr %.193, align 8
  %28 = getelementptr double, ptr %arg.L.4, i64 %arg.L.5.1
  %.2335.peel.12 = load double, ptr %28, align 8
  %.2406.peel.13 = load double, ptr %arg.L.4, align 8
  %.2413.peel.14 = fdiv double 1.000000e+00, %.2406.peel.13
  %.2481.peel.15 = fmul double %.2335.peel.12, %.2413.peel.14
  %.2487.peel.16 = fsub double 0.000000e+00, %.2481.peel.15
  %.2549.125 = getelementptr i8, ptr %28, i64 8
  %.2550.126 = load double, ptr %.2549.125, align 8
  %.2557.127 = fdiv double %.2487.peel.16, %.2550.126
  %.2595.129 = fmul double %.2557.127, %.2557.127
  %.2596.130 = fadd double %.2596, %.2595.129
  store double %.2596.130, ptr %.193, align 8
  %.2686.132 = getelementptr i8, ptr %arg.L.4, i64 8
  store double %.2557.127, ptr %.2686.132, align 8
  %.pre1551.235 = shl i64 %arg.L.5.1, 1
  %29 = getelementptr double, ptr %arg.L.4, i64 %.pre1551.235
  %.2335.peel.237 = load double, ptr %29, align 8
  %.2406.peel.238 = load double, ptr %arg.L.4, align 8
  %.2413.peel.239 = fdiv double 1.000000e+00, %.2406.peel.238
  %.2481.peel.240 = fmul double %.2335.peel.237, %.2413.peel.239
  %.2487.peel.241 = fsub double 0.000000e+00, %.2481.peel.240
  %.2334.247 = getelementptr i8, ptr %29, i64 8
  %.2335.248 = load double, ptr %.2334.247, align 8
  %.2481.254 = fmul double %.2557.127, %.2335.248
  %.2487.255 = fsub double %.2487.peel.241, %.2481.254
  %.2549.260 = getelementptr i8, ptr %29, i64 16
  %.2550.261 = load double, ptr %.2549.260, align 8
  %.2557.262 = fdiv double %.2487.255, %.2550.261
  %.2592.263 = load double, ptr %.193, align 8
  %.2595.264 = fmul double %.2557.262, %.2557.262
  %.2596.265 = fadd double %.2592.263, %.2595.264
  store double %.2596.265, ptr %.193, align 8
  store double %.2557.262, ptr %scevgep298, align 8
  %.pre1551.370 = mul i64 %arg.L.5.1, 3
  %30 = getelementptr double, ptr %arg.L.4, i64 %.pre1551.370
  %.2335.peel.372 = load double, ptr %30, align 8
  %.2406.peel.373 = load double, ptr %arg.L.4, align 8
  %.2413.peel.374 = fdiv double 1.000000e+00, %.2406.peel.373
  %.2481.peel.375 = fmul double %.2335.peel.372, %.2413.peel.374
  %.2487.peel.376 = fsub double 0.000000e+00, %.2481.peel.375
  %.2334.382 = getelementptr i8, ptr %30, i64 8
  %.2335.383 = load double, ptr %.2334.382, align 8
  %.2473.386 = load double, ptr %.2686.132, align 8
  %.2481.389 = fmul double %.2335.383, %.2473.386
  %.2487.390 = fsub double %.2487.peel.376, %.2481.389
  %.2334.382.1 = getelementptr i8, ptr %30, i64 16
  %.2335.383.1 = load double, ptr %.2334.382.1, align 8
  %.2481.389.1 = fmul double %.2557.262, %.2335.383.1
  %.2487.390.1 = fsub double %.2487.390, %.2481.389.1
  %.2549.395 = getelementptr i8, ptr %30, i64 24
  %.2550.396 = load double, ptr %.2549.395, align 8
  %.2557.397 = fdiv double %.2487.390.1, %.2550.396
  %.2592.398 = load double, ptr %.193, align 8
  %.2595.399 = fmul double %.2557.397, %.2557.397
  %.2596.3100 = fadd double %.2592.398, %.2595.399
  store double %.2596.3100, ptr %.193, align 8
  %.2686.3102 = getelementptr i8, ptr %arg.L.4, i64 24
  store double %.2557.397, ptr %.2686.3102, align 8
  %.pre1551.4105 = shl i64 %arg.L.5.1, 2
  %31 = getelementptr double, ptr %arg.L.4, i64 %.pre1551.4105
  %.2335.peel.4107 = load double, ptr %31, align 8
  %.2406.peel.4108 = load double, ptr %arg.L.4, align 8
  %.2413.peel.4109 = fdiv double 1.000000e+00, %.2406.peel.4108
  %.2481.peel.4110 = fmul double %.2335.peel.4107, %.2413.peel.4109
  %.2487.peel.4111 = fsub double 0.000000e+00, %.2481.peel.4110
  %.2334.4117 = getelementptr i8, ptr %31, i64 8
  %.2335.4118 = load double, ptr %.2334.4117, align 8
  %.2473.4121 = load double, ptr %.2686.132, align 8
  %.2481.4124 = fmul double %.2335.4118, %.2473.4121
  %.2487.4125 = fsub double %.2487.peel.4111, %.2481.4124
  %.2334.4117.1 = getelementptr i8, ptr %31, i64 16
  %.2335.4118.1 = load double, ptr %.2334.4117.1, align 8
  %.2473.4121.1 = load double, ptr %scevgep298, align 8
  %.2481.4124.1 = fmul double %.2335.4118.1, %.2473.4121.1
  %.2487.4125.1 = fsub double %.2487.4125, %.2481.4124.1
  %.2334.4117.2 = getelementptr i8, ptr %31, i64 24
  %.2335.4118.2 = load double, ptr %.2334.4117.2, align 8
  %.2481.4124.2 = fmul double %.2557.397, %.2335.4118.2
  %.2487.4125.2 = fsub double %.2487.4125.1, %.2481.4124.2
  %.2549.4130 = getelementptr i8, ptr %31, i64 32
  %.2550.4131 = load double, ptr %.2549.4130, align 8
  %.2557.4132 = fdiv double %.2487.4125.2, %.2550.4131
  %.2592.4133 = load double, ptr %.193, align 8
  %.2595.4134 = fmul double %.2557.4132, %.2557.4132
  %.2596.4135 = fadd double %.2592.4133, %.2595.4134
  store double %.2596.4135, ptr %.193, align 8
  %.2686.4137 = getelementptr i8, ptr %arg.L.4, i64 32
  store double %.2557.4132, ptr %.2686.4137, align 8
  %.pre1551.5140 = mul i64 %arg.L.5.1, 5
  %32 = getelementptr double, ptr %arg.L.4, i64 %.pre1551.5140
  %.2335.peel.5142 = load double, ptr %32, align 8
  %.2406.peel.5143 = load double, ptr %arg.L.4, align 8
  %.2413.peel.5144 = fdiv double 1.000000e+00, %.2406.peel.5143
  %.2481.peel.5145 = fmul double %.2335.peel.5142, %.2413.peel.5144
  %.2487.peel.5146 = fsub double 0.000000e+00, %.2481.peel.5145
  %.2334.5152 = getelementptr i8, ptr %32, i64 8
  %.2335.5153 = load double, ptr %.2334.5152, align 8
  %.2473.5156 = load double, ptr %.2686.132, align 8
  %.2481.5159 = fmul double %.2335.5153, %.2473.5156
  %.2487.5160 = fsub double %.2487.peel.5146, %.2481.5159
  %.2334.5152.1 = getelementptr i8, ptr %32, i64 16
  %.2335.5153.1 = load double, ptr %.2334.5152.1, align 8
  %.2473.5156.1 = load double, ptr %scevgep298, align 8
  %.2481.5159.1 = fmul double %.2335.5153.1, %.2473.5156.1
  %.2487.5160.1 = fsub double %.2487.5160, %.2481.5159.1
  %.2334.5152.2 = getelementptr i8, ptr %32, i64 24
  %.2335.5153.2 = load double, ptr %.2334.5152.2, align 8
  %.2473.5156.2 = load double, ptr %.2686.3102, align 8
  %.2481.5159.2 = fmul double %.2335.5153.2, %.2473.5156.2
  %.2487.5160.2 = fsub double %.2487.5160.1, %.2481.5159.2
  %.2334.5152.3 = getelementptr i8, ptr %32, i64 32
  %.2335.5153.3 = load double, ptr %.2334.5152.3, align 8
  %.2481.5159.3 = fmul double %.2557.4132, %.2335.5153.3
  %.2487.5160.3 = fsub double %.2487.5160.2, %.2481.5159.3
  %.2549.5165 = getelementptr i8, ptr %32, i64 40
  %.2550.5166 = load double, ptr %.2549.5165, align 8
  %.2557.5167 = fdiv double %.2487.5160.3, %.2550.5166
  %.2592.5168 = load double, ptr %.193, align 8
  %.2595.5169 = fmul double %.2557.5167, %.2557.5167
  %.2596.5170 = fadd double %.2592.5168, %.2595.5169
  store double %.2596.5170, ptr %.193, align 8
  %.2686.5172 = getelementptr i8, ptr %arg.L.4, i64 40
  store double %.2557.5167, ptr %.2686.5172, align 8
  %gep1428.1 = getelementptr double, ptr %.2686.132, i64 %arg.L.5.1
  %.2550.1.pre = load double, ptr %.2549.125, align 8
  %.2557.1 = fdiv double 1.000000e+00, %.2550.1.pre
  %.2592.1 = load double, ptr %.193, align 8
  %.2595.1 = fmul double %.2557.1, %.2557.1
  %.2596.1 = fadd double %.2592.1, %.2595.1
  store double %.2596.1, ptr %.193, align 8
  %.2335.peel.1.1 = load double, ptr %.2334.247, align 8
  %.2406.peel.1.1 = load double, ptr %gep1428.1, align 8
  %.2413.peel.1.1 = fdiv double 1.000000e+00, %.2406.peel.1.1
  %.2481.peel.1.1 = fmul double %.2335.peel.1.1, %.2413.peel.1.1
  %.2487.peel.1.1 = fsub double 0.000000e+00, %.2481.peel.1.1
  %.2550.1.1 = load double, ptr %.2549.260, align 8
  %.2557.1.1 = fdiv double %.2487.peel.1.1, %.2550.1.1
  %.2595.1.1 = fmul double %.2557.1.1, %.2557.1.1
  %.2596.1.1 = fadd double %.2596.1, %.2595.1.1
  store double %.2596.1.1, ptr %.193, align 8
  %.2686.1.1 = getelementptr i8, ptr %28, i64 16
  store double %.2557.1.1, ptr %.2686.1.1, align 8
  %.2335.peel.1.2 = load double, ptr %.2334.382, align 8
  %.2406.peel.1.2 = load double, ptr %gep1428.1, align 8
  %.2413.peel.1.2 = fdiv double 1.000000e+00, %.2406.peel.1.2
  %.2481.peel.1.2 = fmul double %.2335.peel.1.2, %.2413.peel.1.2
  %.2487.peel.1.2 = fsub double 0.000000e+00, %.2481.peel.1.2
  %.2335.1.2 = load double, ptr %.2334.382.1, align 8
  %.2481.1.2 = fmul double %.2557.1.1, %.2335.1.2
  %.2487.1.2 = fsub double %.2487.peel.1.2, %.2481.1.2
  %.2550.1.2 = load double, ptr %.2549.395, align 8
  %.2557.1.2 = fdiv double %.2487.1.2, %.2550.1.2
  %.2592.1.2 = load double, ptr %.193, align 8
  %.2595.1.2 = fmul double %.2557.1.2, %.2557.1.2
  %.2596.1.2 = fadd double %.2592.1.2, %.2595.1.2
  store double %.2596.1.2, ptr %.193, align 8
  %.2686.1.2 = getelementptr i8, ptr %28, i64 24
  store double %.2557.1.2, ptr %.2686.1.2, align 8
  %.2335.peel.1.3 = load double, ptr %.2334.4117, align 8
  %.2406.peel.1.3 = load double, ptr %gep1428.1, align 8
  %.2413.peel.1.3 = fdiv double 1.000000e+00, %.2406.peel.1.3
  %.2481.peel.1.3 = fmul double %.2335.peel.1.3, %.2413.peel.1.3
  %.2487.peel.1.3 = fsub double 0.000000e+00, %.2481.peel.1.3
  %.2335.1.3 = load double, ptr %.2334.4117.1, align 8
  %.2473.1.3 = load double, ptr %.2686.1.1, align 8
  %.2481.1.3 = fmul double %.2335.1.3, %.2473.1.3
  %.2487.1.3 = fsub double %.2487.peel.1.3, %.2481.1.3
  %.2335.1.3.1 = load double, ptr %.2334.4117.2, align 8
  %.2481.1.3.1 = fmul double %.2557.1.2, %.2335.1.3.1
  %.2487.1.3.1 = fsub double %.2487.1.3, %.2481.1.3.1
  %.2550.1.3 = load double, ptr %.2549.4130, align 8
  %.2557.1.3 = fdiv double %.2487.1.3.1, %.2550.1.3
  %.2592.1.3 = load double, ptr %.193, align 8
  %.2595.1.3 = fmul double %.2557.1.3, %.2557.1.3
  %.2596.1.3 = fadd double %.2592.1.3, %.2595.1.3
  store double %.2596.1.3, ptr %.193, align 8
  %.2686.1.3 = getelementptr i8, ptr %28, i64 32
  store double %.2557.1.3, ptr %.2686.1.3, align 8
  %.2335.peel.1.4 = load double, ptr %.2334.5152, align 8
  %.2406.peel.1.4 = load double, ptr %gep1428.1, align 8
  %.2413.peel.1.4 = fdiv double 1.000000e+00, %.2406.peel.1.4
  %.2481.peel.1.4 = fmul double %.2335.peel.1.4, %.2413.peel.1.4
  %.2487.peel.1.4 = fsub double 0.000000e+00, %.2481.peel.1.4
  %.2335.1.4 = load double, ptr %.2334.5152.1, align 8
  %.2473.1.4 = load double, ptr %.2686.1.1, align 8
  %.2481.1.4 = fmul double %.2335.1.4, %.2473.1.4
  %.2487.1.4 = fsub double %.2487.peel.1.4, %.2481.1.4
  %.2335.1.4.1 = load double, ptr %.2334.5152.2, align 8
  %.2473.1.4.1 = load double, ptr %.2686.1.2, align 8
  %.2481.1.4.1 = fmul double %.2335.1.4.1, %.2473.1.4.1
  %.2487.1.4.1 = fsub double %.2487.1.4, %.2481.1.4.1
  %.2335.1.4.2 = load double, ptr %.2334.5152.3, align 8
  %.2481.1.4.2 = fmul double %.2557.1.3, %.2335.1.4.2
  %.2487.1.4.2 = fsub double %.2487.1.4.1, %.2481.1.4.2
  %.2550.1.4 = load double, ptr %.2549.5165, align 8
  %.2557.1.4 = fdiv double %.2487.1.4.2, %.2550.1.4
  %.2592.1.4 = load double, ptr %.193, align 8
  %.2595.1.4 = fmul double %.2557.1.4, %.2557.1.4
  %.2596.1.4 = fadd double %.2592.1.4, %.2595.1.4
  store double %.2596.1.4, ptr %.193, align 8
  %.2686.1.4 = getelementptr i8, ptr %28, i64 40
  store double %.2557.1.4, ptr %.2686.1.4, align 8
  %gep1428.2 = getelementptr double, ptr %scevgep298, i64 %.pre1551.235
  %.2550.2.pre = load double, ptr %.2549.260, align 8
  %.2557.2 = fdiv double 1.000000e+00, %.2550.2.pre
  %.2592.2 = load double, ptr %.193, align 8
  %.2595.2 = fmul double %.2557.2, %.2557.2
  %.2596.2 = fadd double %.2592.2, %.2595.2
  store double %.2596.2, ptr %.193, align 8
  %.2335.peel.2.1 = load double, ptr %.2334.382.1, align 8
  %.2406.peel.2.1 = load double, ptr %gep1428.2, align 8
  %.2413.peel.2.1 = fdiv double 1.000000e+00, %.2406.peel.2.1
  %.2481.peel.2.1 = fmul double %.2335.peel.2.1, %.2413.peel.2.1
  %.2487.peel.2.1 = fsub double 0.000000e+00, %.2481.peel.2.1
  %.2550.2.1 = load double, ptr %.2549.395, align 8
  %.2557.2.1 = fdiv double %.2487.peel.2.1, %.2550.2.1
  %.2595.2.1 = fmul double %.2557.2.1, %.2557.2.1
  %.2596.2.1 = fadd double %.2596.2, %.2595.2.1
  store double %.2596.2.1, ptr %.193, align 8
  %.2686.2.1 = getelementptr i8, ptr %29, i64 24
  store double %.2557.2.1, ptr %.2686.2.1, align 8
  %.2335.peel.2.2 = load double, ptr %.2334.4117.1, align 8
  %.2406.peel.2.2 = load double, ptr %gep1428.2, align 8
  %.2413.peel.2.2 = fdiv double 1.000000e+00, %.2406.peel.2.2
  %.2481.peel.2.2 = fmul double %.2335.peel.2.2, %.2413.peel.2.2
  %.2487.peel.2.2 = fsub double 0.000000e+00, %.2481.peel.2.2
  %.2335.2.2 = load double, ptr %.2334.4117.2, align 8
  %.2481.2.2 = fmul double %.2557.2.1, %.2335.2.2
  %.2487.2.2 = fsub double %.2487.peel.2.2, %.2481.2.2
  %.2550.2.2 = load double, ptr %.2549.4130, align 8
  %.2557.2.2 = fdiv double %.2487.2.2, %.2550.2.2
  %.2592.2.2 = load double, ptr %.193, align 8
  %.2595.2.2 = fmul double %.2557.2.2, %.2557.2.2
  %.2596.2.2 = fadd double %.2592.2.2, %.2595.2.2
  store double %.2596.2.2, ptr %.193, align 8
  %.2686.2.2 = getelementptr i8, ptr %29, i64 32
  store double %.2557.2.2, ptr %.2686.2.2, align 8
  %.2335.peel.2.3 = load double, ptr %.2334.5152.1, align 8
  %.2406.peel.2.3 = load double, ptr %gep1428.2, align 8
  %.2413.peel.2.3 = fdiv double 1.000000e+00, %.2406.peel.2.3
  %.2481.peel.2.3 = fmul double %.2335.peel.2.3, %.2413.peel.2.3
  %.2487.peel.2.3 = fsub double 0.000000e+00, %.2481.peel.2.3
  %.2335.2.3 = load double, ptr %.2334.5152.2, align 8
  %.2473.2.3 = load double, ptr %.2686.2.1, align 8
  %.2481.2.3 = fmul double %.2335.2.3, %.2473.2.3
  %.2487.2.3 = fsub double %.2487.peel.2.3, %.2481.2.3
  %.2335.2.3.1 = load double, ptr %.2334.5152.3, align 8
  %.2481.2.3.1 = fmul double %.2557.2.2, %.2335.2.3.1
  %.2487.2.3.1 = fsub double %.2487.2.3, %.2481.2.3.1
  %.2550.2.3 = load double, ptr %.2549.5165, align 8
  %.2557.2.3 = fdiv double %.2487.2.3.1, %.2550.2.3
  %.2592.2.3 = load double, ptr %.193, align 8
  %.2595.2.3 = fmul double %.2557.2.3, %.2557.2.3
  %.2596.2.3 = fadd double %.2592.2.3, %.2595.2.3
  store double %.2596.2.3, ptr %.193, align 8
  %.2686.2.3 = getelementptr i8, ptr %29, i64 40
  store double %.2557.2.3, ptr %.2686.2.3, align 8
  %gep1428.3 = getelementptr double, ptr %.2686.3102, i64 %.pre1551.370
  %.2550.3.pre = load double, ptr %.2549.395, align 8
  %.2557.3 = fdiv double 1.000000e+00, %.2550.3.pre
  %.2592.3 = load double, ptr %.193, align 8
  %.2595.3 = fmul double %.2557.3, %.2557.3
  %.2596.3 = fadd double %.2592.3, %.2595.3
  store double %.2596.3, ptr %.193, align 8
  %.2335.peel.3.1 = load double, ptr %.2334.4117.2, align 8
  %.2406.peel.3.1 = load double, ptr %gep1428.3, align 8
  %.2413.peel.3.1 = fdiv double 1.000000e+00, %.2406.peel.3.1
  %.2481.peel.3.1 = fmul double %.2335.peel.3.1, %.2413.peel.3.1
  %.2487.peel.3.1 = fsub double 0.000000e+00, %.2481.peel.3.1
  %.2550.3.1 = load double, ptr %.2549.4130, align 8
  %.2557.3.1 = fdiv double %.2487.peel.3.1, %.2550.3.1
  %.2595.3.1 = fmul double %.2557.3.1, %.2557.3.1
  %.2596.3.1 = fadd double %.2596.3, %.2595.3.1
  store double %.2596.3.1, ptr %.193, align 8
  %.2686.3.1 = getelementptr i8, ptr %30, i64 32
  store double %.2557.3.1, ptr %.2686.3.1, align 8
  %.2335.peel.3.2 = load double, ptr %.2334.5152.2, align 8
  %.2406.peel.3.2 = load double, ptr %gep1428.3, align 8
  %.2413.peel.3.2 = fdiv double 1.000000e+00, %.2406.peel.3.2
  %.2481.peel.3.2 = fmul double %.2335.peel.3.2, %.2413.peel.3.2
  %.2487.peel.3.2 = fsub double 0.000000e+00, %.2481.peel.3.2
  %.2335.3.2 = load double, ptr %.2334.5152.3, align 8
  %.2481.3.2 = fmul double %.2557.3.1, %.2335.3.2
  %.2487.3.2 = fsub double %.2487.peel.3.2, %.2481.3.2
  %.2550.3.2 = load double, ptr %.2549.5165, align 8
  %.2557.3.2 = fdiv double %.2487.3.2, %.2550.3.2
  %.2592.3.2 = load double, ptr %.193, align 8
  %.2595.3.2 = fmul double %.2557.3.2, %.2557.3.2
  %.2596.3.2 = fadd double %.2592.3.2, %.2595.3.2
  store double %.2596.3.2, ptr %.193, align 8
  %.2686.3.2 = getelementptr i8, ptr %30, i64 40
  store double %.2557.3.2, ptr %.2686.3.2, align 8
  %gep1428.4 = getelementptr double, ptr %.2686.4137, i64 %.pre1551.4105
  %.2550.4.pre = load double, ptr %.2549.4130, align 8
  %.2557.4 = fdiv double 1.000000e+00, %.2550.4.pre
  %.2592.4 = load double, ptr %.193, align 8
  %.2595.4 = fmul double %.2557.4, %.2557.4
  %.2596.4 = fadd double %.2592.4, %.2595.4
  store double %.2596.4, ptr %.193, align 8
  %.2335.peel.4.1 = load double, ptr %.2334.5152.3, align 8
  %.2406.peel.4.1 = load double, ptr %gep1428.4, align 8
  %.2413.peel.4.1 = fdiv double 1.000000e+00, %.2406.peel.4.1
  %.2481.peel.4.1 = fmul double %.2335.peel.4.1, %.2413.peel.4.1
  %.2487.peel.4.1 = fsub double 0.000000e+00, %.2481.peel.4.1
  %.2550.4.1 = load double, ptr %.2549.5165, align 8
  %.2557.4.1 = fdiv double %.2487.peel.4.1, %.2550.4.1
  %.2595.4.1 = fmul double %.2557.4.1, %.2557.4.1
  %.2596.4.1 = fadd double %.2596.4, %.2595.4.1
  store double %.2596.4.1, ptr %.193, align 8
  %.2686.4.1 = getelementptr i8, ptr %31, i64 40
  store double %.2557.4.1, ptr %.2686.4.1, align 8
  %.2550.5.pre = load double, ptr %.2549.5165, align 8
  %.2557.5 = fdiv double 1.000000e+00, %.2550.5.pre
  %.2592.5 = load double, ptr %.193, align 8
  %.2595.5 = fmul double %.2557.5, %.2557.5
  %.2596.5 = fadd double %.2592.5, %.2595.5
  store double %.2596.5, ptr %.193, align 8
  %.2977.promoted.5.pre = load double, ptr %arg.out.4, align 8
  %.2977.promoted.4.pre = load double, ptr %sunkaddr325, align 8
  %.2977.promoted.3.pre = load double, ptr %sunkaddr331, align 8
  %.2977.promoted.2.pre = load double, ptr %sunkaddr337, align 8
  %.2977.promoted.1.pre = load double, ptr %sunkaddr343, align 8
  %.3186.pre = load double, ptr %.2549.5165, align 8
  %.phi.trans.insert.phi.trans.insert = getelementptr i8, ptr %arg.out.4, i64 40
  %.3132.pre.pre = load double, ptr %.phi.trans.insert.phi.trans.insert, align 8
  %.3192 = fdiv double %.3132.pre.pre, %.3186.pre
  store double %.3192, ptr %.phi.trans.insert.phi.trans.insert, align 8
  %gep1480.1 = getelementptr double, ptr %.2686.4137, i64 %.pre1551.5140
  %.3031.1 = load double, ptr %gep1480.1, align 8
  %.3064.1 = fmul double %.3192, %.3031.1
  %.3065.1 = fsub double %.2977.promoted.1.pre, %.3064.1
  store double %.3065.1, ptr %sunkaddr343, align 8
  %.3186.1 = load double, ptr %.2549.4130, align 8
  %.3192.1 = fdiv double %.3065.1, %.3186.1
  store double %.3192.1, ptr %sunkaddr343, align 8
  %gep1480.2 = getelementptr double, ptr %.2686.3102, i64 %.pre1551.4105
  %.3031.2 = load double, ptr %gep1480.2, align 8
  %.3064.2 = fmul double %.3192.1, %.3031.2
  %.3065.2 = fsub double %.2977.promoted.2.pre, %.3064.2
  store double %.3065.2, ptr %sunkaddr337, align 8
  %gep1480.2.1 = getelementptr double, ptr %.2686.3102, i64 %.pre1551.5140
  %.3031.2.1 = load double, ptr %gep1480.2.1, align 8
  %.3064.2.1 = fmul double %.3192, %.3031.2.1
  %.3065.2.1 = fsub double %.3065.2, %.3064.2.1
  store double %.3065.2.1, ptr %sunkaddr337, align 8
  %.3186.2 = load double, ptr %.2549.395, align 8
  %.3192.2 = fdiv double %.3065.2.1, %.3186.2
  store double %.3192.2, ptr %sunkaddr337, align 8
  %gep1480.3 = getelementptr double, ptr %scevgep298, i64 %.pre1551.370
  %.3031.3 = load double, ptr %gep1480.3, align 8
  %.3064.3 = fmul double %.3192.2, %.3031.3
  %.3065.3 = fsub double %.2977.promoted.3.pre, %.3064.3
  store double %.3065.3, ptr %sunkaddr331, align 8
  %gep1480.3.1 = getelementptr double, ptr %scevgep298, i64 %.pre1551.4105
  %.3031.3.1 = load double, ptr %gep1480.3.1, align 8
  %.3064.3.1 = fmul double %.3192.1, %.3031.3.1
  %.3065.3.1 = fsub double %.3065.3, %.3064.3.1
  store double %.3065.3.1, ptr %sunkaddr331, align 8
  %gep1480.3.2 = getelementptr double, ptr %scevgep298, i64 %.pre1551.5140
  %.3031.3.2 = load double, ptr %gep1480.3.2, align 8
  %.3064.3.2 = fmul double %.3192, %.3031.3.2
  %.3065.3.2 = fsub double %.3065.3.1, %.3064.3.2
  store double %.3065.3.2, ptr %sunkaddr331, align 8
  %.3186.3 = load double, ptr %.2549.260, align 8
  %.3192.3 = fdiv double %.3065.3.2, %.3186.3
  store double %.3192.3, ptr %sunkaddr331, align 8
  %gep1480.4 = getelementptr double, ptr %.2686.132, i64 %.pre1551.235
  %.3031.4 = load double, ptr %gep1480.4, align 8
  %.3064.4 = fmul double %.3192.3, %.3031.4
  %.3065.4 = fsub double %.2977.promoted.4.pre, %.3064.4
  store double %.3065.4, ptr %sunkaddr325, align 8
  %gep1480.4.1 = getelementptr double, ptr %.2686.132, i64 %.pre1551.370
  %.3031.4.1 = load double, ptr %gep1480.4.1, align 8
  %.3064.4.1 = fmul double %.3192.2, %.3031.4.1
  %.3065.4.1 = fsub double %.3065.4, %.3064.4.1
  store double %.3065.4.1, ptr %sunkaddr325, align 8
  %gep1480.4.2 = getelementptr double, ptr %.2686.132, i64 %.pre1551.4105
  %.3031.4.2 = load double, ptr %gep1480.4.2, align 8
  %.3064.4.2 = fmul double %.3192.1, %.3031.4.2
  %.3065.4.2 = fsub double %.3065.4.1, %.3064.4.2
  store double %.3065.4.2, ptr %sunkaddr325, align 8
  %gep1480.4.3 = getelementptr double, ptr %.2686.132, i64 %.pre1551.5140
  %.3031.4.3 = load double, ptr %gep1480.4.3, align 8
  %.3064.4.3 = fmul double %.3192, %.3031.4.3
  %.3065.4.3 = fsub double %.3065.4.2, %.3064.4.3
  store double %.3065.4.3, ptr %sunkaddr325, align 8
  %.3186.4 = load double, ptr %.2549.125, align 8
  %.3192.4 = fdiv double %.3065.4.3, %.3186.4
  store double %.3192.4, ptr %sunkaddr325, align 8
  %.3031.5 = load double, ptr %28, align 8
  %.3064.5 = fmul double %.3192.4, %.3031.5
  %.3065.5 = fsub double %.2977.promoted.5.pre, %.3064.5
  store double %.3065.5, ptr %arg.out.4, align 8
  %.3031.5.1 = load double, ptr %29, align 8
  %.3064.5.1 = fmul double %.3192.3, %.3031.5.1
  %.3065.5.1 = fsub double %.3065.5, %.3064.5.1
  store double %.3065.5.1, ptr %arg.out.4, align 8
  %.3031.5.2 = load double, ptr %30, align 8
  %.3064.5.2 = fmul double %.3192.2, %.3031.5.2
  %.3065.5.2 = fsub double %.3065.5.1, %.3064.5.2
  store double %.3065.5.2, ptr %arg.out.4, align 8
  %.3031.5.3 = load double, ptr %31, align 8
  %.3064.5.3 = fmul double %.3192.1, %.3031.5.3
  %.3065.5.3 = fsub double %.3065.5.2, %.3064.5.3
  store double %.3065.5.3, ptr %arg.out.4, align 8
  %.3031.5.4 = load double, ptr %32, align 8
  %.3064.5.4 = fmul double %.3192, %.3031.5.4
  %.3065.5.4 = fsub double %.3065.5.3, %.3064.5.4
  store double %.3065.5.4, ptr %arg.out.4, align 8
  %.3186.5 = load double, ptr %arg.L.4, align 8
  %.3192.5 = fdiv double %.3065.5.4, %.3186.5
  store double %.3192.5, ptr %arg.out.4, align 8
  %33 = getelementptr i8, ptr %arg.arm.4, i64 48
  %.3577 = load double, ptr %33, align 8
  %.3579 = fmul double %.3192.5, %.3577
  %34 = getelementptr i8, ptr %arg.arm.4, i64 56
  %.3611 = load double, ptr %34, align 8
  %.3613 = fmul double %.3192.4, %.3611
  %.3614 = fadd double %.3579, %.3613
  %35 = getelementptr i8, ptr %arg.arm.4, i64 64
  %.3646 = load double, ptr %35, align 8
  %.3648 = fmul double %.3192.3, %.3646
  %.3649 = fadd double %.3614, %.3648
  store double %.3649, ptr %arg.out.4, align 8
  %36 = getelementptr i8, ptr %arg.arm.4, i64 72
  %.3577.1 = load double, ptr %36, align 8
  %.3579.1 = fmul double %.3192.5, %.3577.1
  %37 = getelementptr i8, ptr %arg.arm.4, i64 80
  %.3611.1 = load double, ptr %37, align 8
  %.3613.1 = fmul double %.3192.4, %.3611.1
  %.3614.1 = fadd double %.3579.1, %.3613.1
  %38 = getelementptr i8, ptr %arg.arm.4, i64 88
  %.3646.1 = load double, ptr %38, align 8
  %.3648.1 = fmul double %.3192.3, %.3646.1
  %.3649.1 = fadd double %.3614.1, %.3648.1
  store double %.3649.1, ptr %sunkaddr325, align 8
  %39 = getelementptr i8, ptr %arg.arm.4, i64 96
  %.3577.2 = load double, ptr %39, align 8
  %.3579.2 = fmul double %.3192.5, %.3577.2
  %40 = getelementptr i8, ptr %arg.arm.4, i64 104
  %.3611.2 = load double, ptr %40, align 8
  %.3613.2 = fmul double %.3192.4, %.3611.2
  %.3614.2 = fadd double %.3579.2, %.3613.2
  %41 = getelementptr i8, ptr %arg.arm.4, i64 112
  %.3646.2 = load double, ptr %41, align 8
  %.3648.2 = fmul double %.3192.3, %.3646.2
  %.3649.2 = fadd double %.3614.2, %.3648.2
  store double %.3649.2, ptr %sunkaddr331, align 8
  %.3577.11526 = load double, ptr %33, align 8
  %.3579.11527 = fmul double %.3192.2, %.3577.11526
  %.3611.11528 = load double, ptr %34, align 8
  %.3613.11529 = fmul double %.3192.1, %.3611.11528
  %.3614.11530 = fadd double %.3579.11527, %.3613.11529
  %.3646.11531 = load double, ptr %35, align 8
  %.3648.11532 = fmul double %.3192, %.3646.11531
  %.3649.11533 = fadd double %.3614.11530, %.3648.11532
  store double %.3649.11533, ptr %sunkaddr337, align 8
  %.3577.1.1 = load double, ptr %36, align 8
  %.3579.1.1 = fmul double %.3192.2, %.3577.1.1
  %.3611.1.1 = load double, ptr %37, align 8
  %.3613.1.1 = fmul double %.3192.1, %.3611.1.1
  %.3614.1.1 = fadd double %.3579.1.1, %.3613.1.1
  %.3646.1.1 = load double, ptr %38, align 8
  %.3648.1.1 = fmul double %.3192, %.3646.1.1
  %.3649.1.1 = fadd double %.3614.1.1, %.3648.1.1
  store double %.3649.1.1, ptr %sunkaddr343, align 8
  %.3577.2.1 = load double, ptr %39, align 8
  %.3579.2.1 = fmul double %.3192.2, %.3577.2.1
  %.3611.2.1 = load double, ptr %40, align 8
  %.3613.2.1 = fmul double %.3192.1, %.3611.2.1
  %.3614.2.1 = fadd double %.3579.2.1, %.3613.2.1
  %.3646.2.1 = load double, ptr %41, align 8
  %.3648.2.1 = fmul double %.3192, %.3646.2.1
  %.3649.2.1 = fadd double %.3614.2.1, %.3648.2.1
  store double %.3649.2.1, ptr %.phi.trans.insert.phi.trans.insert, align 8
  br label %common.ret.sink.split

B1427:                                            ; preds = %B500, %B422
  %lsr.iv.next = add nuw i64 %lsr.iv, 1
  %exitcond1517.not = icmp eq i64 %.28113841413, %24
  br i1 %exitcond1517.not, label %B542.endif, label %B358.2, !llvm.loop !5

B236.endif.endif.lr.ph:                           ; preds = %part.0, %B644
  %lsr.iv299 = phi ptr [ %scevgep300, %B644 ], [ %scevgep298, %part.0 ]
  %indvars.iv = phi i64 [ %indvars.iv.next, %B644 ], [ 1, %part.0 ]
  %.28113841413 = phi i64 [ %.288, %B644 ], [ 0, %part.0 ]
  %42 = getelementptr double, ptr %arg.out.4, i64 %.28113841413
  store double 0.000000e+00, ptr %42, align 8
  %.542 = mul i64 %.28113841413, %arg.J.5.1
  %43 = getelementptr double, ptr %arg.J.4, i64 %.542
  %.547 = load double, ptr %43, align 8
  %.579 = load double, ptr %arg.tau.4, align 8
  %.580 = fmul double %.547, %.579
  %.581 = fadd double %.580, 0.000000e+00
  store double %.581, ptr %42, align 8
  %44 = getelementptr i8, ptr %43, i64 8
  %.547.1 = load double, ptr %44, align 8
  %.579.1 = load double, ptr %sunkaddr349, align 8
  %.580.1 = fmul double %.547.1, %.579.1
  %.581.1 = fadd double %.581, %.580.1
  store double %.581.1, ptr %42, align 8
  %45 = getelementptr i8, ptr %43, i64 16
  %.547.2 = load double, ptr %45, align 8
  %.579.2 = load double, ptr %sunkaddr350, align 8
  %.580.2 = fmul double %.547.2, %.579.2
  %.581.2 = fadd double %.581.1, %.580.2
  store double %.581.2, ptr %42, align 8
  %46 = getelementptr i8, ptr %43, i64 24
  %.547.3 = load double, ptr %46, align 8
  %.579.3 = load double, ptr %sunkaddr351, align 8
  %.580.3 = fmul double %.547.3, %.579.3
  %.581.3 = fadd double %.581.2, %.580.3
  store double %.581.3, ptr %42, align 8
  %47 = getelementptr i8, ptr %43, i64 32
  %.547.4 = load double, ptr %47, align 8
  %.579.4 = load double, ptr %sunkaddr352, align 8
  %.580.4 = fmul double %.547.4, %.579.4
  %.581.4 = fadd double %.581.3, %.580.4
  store double %.581.4, ptr %42, align 8
  %48 = getelementptr i8, ptr %43, i64 40
  %.547.5 = load double, ptr %48, align 8
  %.579.5 = load double, ptr %sunkaddr353, align 8
  %.580.5 = fmul double %.547.5, %.579.5
  %.581.5 = fadd double %.581.4, %.580.5
  store double %.581.5, ptr %42, align 8
  %49 = getelementptr i8, ptr %43, i64 48
  %.547.6 = load double, ptr %49, align 8
  %.579.6 = load double, ptr %sunkaddr354, align 8
  %.580.6 = fmul double %.547.6, %.579.6
  %.581.6 = fadd double %.581.5, %.580.6
  store double %.581.6, ptr %42, align 8
  %.288 = add nuw nsw i64 %.28113841413, 1
  %invariant.gep = getelementptr double, ptr %arg.L.4, i64 %.28113841413
  %.1151 = mul i64 %.28113841413, %arg.L.5.1
  %.912.peel = load double, ptr %43, align 8
  %.967.peel = load double, ptr %arg.J.4, align 8
  %.970.peel = fmul double %.912.peel, %.967.peel
  %.972.peel = fadd double %.970.peel, 0.000000e+00
  %.912.1.peel = load double, ptr %44, align 8
  %.967.1.peel = load double, ptr %.2618.1.i, align 8
  %.970.1.peel = fmul double %.912.1.peel, %.967.1.peel
  %.972.1.peel = fadd double %.972.peel, %.970.1.peel
  %.912.2.peel = load double, ptr %45, align 8
  %.967.2.peel = load double, ptr %.2618.2.i, align 8
  %.970.2.peel = fmul double %.912.2.peel, %.967.2.peel
  %.972.2.peel = fadd double %.972.1.peel, %.970.2.peel
  %.912.3.peel = load double, ptr %46, align 8
  %.967.3.peel = load double, ptr %.2618.3.i, align 8
  %.970.3.peel = fmul double %.912.3.peel, %.967.3.peel
  %.972.3.peel = fadd double %.972.2.peel, %.970.3.peel
  %.912.4.peel = load double, ptr %47, align 8
  %.967.4.peel = load double, ptr %.2618.4.i, align 8
  %.970.4.peel = fmul double %.912.4.peel, %.967.4.peel
  %.972.4.peel = fadd double %.972.3.peel, %.970.4.peel
  %.912.5.peel = load double, ptr %48, align 8
  %.967.5.peel = load double, ptr %.2618.5.i, align 8
  %.970.5.peel = fmul double %.912.5.peel, %.967.5.peel
  %.972.5.peel = fadd double %.972.4.peel, %.970.5.peel
  %.912.6.peel = load double, ptr %49, align 8
  %.967.6.peel = load double, ptr %.2618.6.i, align 8
  %.970.6.peel = fmul double %.912.6.peel, %.967.6.peel
  %.972.6.peel = fadd double %.972.5.peel, %.970.6.peel
  %.1226.peel.not = icmp eq i64 %.28113841413, 0
  br i1 %.1226.peel.not, label %B460.peel, label %B422.peel

B460.peel:                                        ; preds = %B236.endif.endif.lr.ph
  %.1353.peel = fcmp ogt double %.972.6.peel, 0.000000e+00
  br i1 %.1353.peel, label %B500.peel, label %B472

B500.peel:                                        ; preds = %B460.peel
  %.1425.peel = tail call double @sqrt(double %.972.6.peel)
  store double %.1425.peel, ptr %invariant.gep, align 8
  br label %B1427.peel

B422.peel:                                        ; preds = %B236.endif.endif.lr.ph
  %.1281.peel = load double, ptr %arg.L.4, align 8
  %.1288.peel = fdiv double %.972.6.peel, %.1281.peel
  %sunkaddr363 = shl i64 %.1151, 3
  %sunkaddr364 = getelementptr i8, ptr %arg.L.4, i64 %sunkaddr363
  store double %.1288.peel, ptr %sunkaddr364, align 8
  br label %B1427.peel

B1427.peel:                                       ; preds = %B422.peel, %B500.peel
  %exitcond1517.not.peel = icmp eq i64 %indvars.iv, 1
  br i1 %exitcond1517.not.peel, label %B542.endif, label %B236.endif.endif.peel192

B236.endif.endif.peel192:                         ; preds = %B1427.peel
  %sunkaddr365 = shl i64 %.542, 3
  %sunkaddr366 = getelementptr i8, ptr %arg.J.4, i64 %sunkaddr365
  %.912.peel194 = load double, ptr %sunkaddr366, align 8
  %.967.peel195 = load double, ptr %scevgep13.i, align 8
  %.970.peel196 = fmul double %.912.peel194, %.967.peel195
  %.972.peel197 = fadd double %.970.peel196, 0.000000e+00
  %sunkaddr371 = getelementptr i8, ptr %sunkaddr366, i64 8
  %.912.1.peel198 = load double, ptr %sunkaddr371, align 8
  %.967.1.peel200 = load double, ptr %sunkaddr40.i, align 8
  %.970.1.peel201 = fmul double %.912.1.peel198, %.967.1.peel200
  %.972.1.peel202 = fadd double %.972.peel197, %.970.1.peel201
  %sunkaddr377 = getelementptr i8, ptr %sunkaddr366, i64 16
  %.912.2.peel203 = load double, ptr %sunkaddr377, align 8
  %.967.2.peel205 = load double, ptr %sunkaddr43.i, align 8
  %.970.2.peel206 = fmul double %.912.2.peel203, %.967.2.peel205
  %.972.2.peel207 = fadd double %.972.1.peel202, %.970.2.peel206
  %sunkaddr383 = getelementptr i8, ptr %sunkaddr366, i64 24
  %.912.3.peel208 = load double, ptr %sunkaddr383, align 8
  %.967.3.peel210 = load double, ptr %sunkaddr46.i, align 8
  %.970.3.peel211 = fmul double %.912.3.peel208, %.967.3.peel210
  %.972.3.peel212 = fadd double %.972.2.peel207, %.970.3.peel211
  %sunkaddr389 = getelementptr i8, ptr %sunkaddr366, i64 32
  %.912.4.peel213 = load double, ptr %sunkaddr389, align 8
  %.967.4.peel215 = load double, ptr %sunkaddr49.i, align 8
  %.970.4.peel216 = fmul double %.912.4.peel213, %.967.4.peel215
  %.972.4.peel217 = fadd double %.972.3.peel212, %.970.4.peel216
  %sunkaddr395 = getelementptr i8, ptr %sunkaddr366, i64 40
  %.912.5.peel218 = load double, ptr %sunkaddr395, align 8
  %.967.5.peel220 = load double, ptr %sunkaddr52.i, align 8
  %.970.5.peel221 = fmul double %.912.5.peel218, %.967.5.peel220
  %.972.5.peel222 = fadd double %.972.4.peel217, %.970.5.peel221
  %sunkaddr401 = getelementptr i8, ptr %sunkaddr366, i64 48
  %.912.6.peel223 = load double, ptr %sunkaddr401, align 8
  %.967.6.peel225 = load double, ptr %sunkaddr55.i, align 8
  %.970.6.peel226 = fmul double %.912.6.peel223, %.967.6.peel225
  %.972.6.peel227 = fadd double %.972.5.peel222, %.970.6.peel226
  %sunkaddr405 = shl i64 %.1151, 3
  %sunkaddr406 = getelementptr i8, ptr %arg.L.4, i64 %sunkaddr405
  %.1156.peel233 = load double, ptr %sunkaddr406, align 8
  %.1211.peel234 = load double, ptr %sunkaddr408, align 8
  %.1214.peel235 = fmul double %.1156.peel233, %.1211.peel234
  %.1216.peel236 = fsub double %.972.6.peel227, %.1214.peel235
  %.1226.peel273 = icmp samesign ugt i64 %.28113841413, 1
  br i1 %.1226.peel273, label %B422.peel278, label %B460.peel274

B460.peel274:                                     ; preds = %B236.endif.endif.peel192
  %.1353.peel275 = fcmp ogt double %.1216.peel236, 0.000000e+00
  br i1 %.1353.peel275, label %B500.peel276, label %B472

B500.peel276:                                     ; preds = %B460.peel274
  %.1425.peel277 = tail call double @sqrt(double %.1216.peel236)
  %sunkaddr410 = getelementptr i8, ptr %invariant.gep, i64 %sunkaddr405
  store double %.1425.peel277, ptr %sunkaddr410, align 8
  br label %B1427.peel284

B422.peel278:                                     ; preds = %B236.endif.endif.peel192
  %.1281.peel281 = load double, ptr %sunkaddr413, align 8
  %.1288.peel282 = fdiv double %.1216.peel236, %.1281.peel281
  %sunkaddr416 = getelementptr i8, ptr %sunkaddr406, i64 8
  store double %.1288.peel282, ptr %sunkaddr416, align 8
  br label %B1427.peel284

B1427.peel284:                                    ; preds = %B422.peel278, %B500.peel276
  %exitcond1517.not.peel285 = icmp eq i64 %indvars.iv, 2
  br i1 %exitcond1517.not.peel285, label %B542.endif, label %B410.peel

B410.peel:                                        ; preds = %B1427.peel284
  %sunkaddr441 = getelementptr i8, ptr %sunkaddr406, i64 8
  %sunkaddr312 = getelementptr i8, ptr %sunkaddr406, i64 16
  %sunkaddr315 = getelementptr i8, ptr %sunkaddr406, i64 24
  %sunkaddr318 = getelementptr i8, ptr %sunkaddr406, i64 32
  %sunkaddr321 = getelementptr inbounds i8, ptr %invariant.gep, i64 %sunkaddr405
  %.912.peel3 = load double, ptr %sunkaddr366, align 8
  %.967.peel4 = load double, ptr %gep1126.2.peel.i, align 8
  %.970.peel5 = fmul double %.912.peel3, %.967.peel4
  %.972.peel6 = fadd double %.970.peel5, 0.000000e+00
  %.912.1.peel7 = load double, ptr %sunkaddr371, align 8
  %.967.1.peel8 = load double, ptr %scevgep309.peel, align 8
  %.970.1.peel9 = fmul double %.912.1.peel7, %.967.1.peel8
  %.972.1.peel10 = fadd double %.972.peel6, %.970.1.peel9
  %.912.2.peel11 = load double, ptr %sunkaddr377, align 8
  %.967.2.peel12 = load double, ptr %scevgep308.peel, align 8
  %.970.2.peel13 = fmul double %.912.2.peel11, %.967.2.peel12
  %.972.2.peel14 = fadd double %.972.1.peel10, %.970.2.peel13
  %.912.3.peel15 = load double, ptr %sunkaddr383, align 8
  %.967.3.peel16 = load double, ptr %scevgep307.peel, align 8
  %.970.3.peel17 = fmul double %.912.3.peel15, %.967.3.peel16
  %.972.3.peel18 = fadd double %.972.2.peel14, %.970.3.peel17
  %.912.4.peel19 = load double, ptr %sunkaddr389, align 8
  %.967.4.peel20 = load double, ptr %scevgep306.peel, align 8
  %.970.4.peel21 = fmul double %.912.4.peel19, %.967.4.peel20
  %.972.4.peel22 = fadd double %.972.3.peel18, %.970.4.peel21
  %.912.5.peel23 = load double, ptr %sunkaddr395, align 8
  %.967.5.peel24 = load double, ptr %scevgep305.peel, align 8
  %.970.5.peel25 = fmul double %.912.5.peel23, %.967.5.peel24
  %.972.5.peel26 = fadd double %.972.4.peel22, %.970.5.peel25
  %.912.6.peel27 = load double, ptr %sunkaddr401, align 8
  %.967.6.peel28 = load double, ptr %.2836.6.i, align 8
  %.970.6.peel29 = fmul double %.912.6.peel27, %.967.6.peel28
  %.972.6.peel30 = fadd double %.972.5.peel26, %.970.6.peel29
  %.1156.peel = load double, ptr %sunkaddr406, align 8
  %.1211.peel = load double, ptr %20, align 8
  %.1214.peel = fmul double %.1156.peel, %.1211.peel
  %.1216.peel = fsub double %.972.6.peel30, %.1214.peel
  %.1156.1.peel = load double, ptr %sunkaddr441, align 8
  %.1211.1.peel = load double, ptr %scevgep293.peel, align 8
  %.1214.1.peel = fmul double %.1156.1.peel, %.1211.1.peel
  %.1216.1.peel = fsub double %.1216.peel, %.1214.1.peel
  %.1226.peel = icmp samesign ugt i64 %.28113841413, 2
  br i1 %.1226.peel, label %B1427.peel38.thread, label %B460.peel31

B460.peel31:                                      ; preds = %B410.peel
  %.1353.peel32 = fcmp ogt double %.1216.1.peel, 0.000000e+00
  br i1 %.1353.peel32, label %B1427.peel38, label %B472

B1427.peel38.thread:                              ; preds = %B410.peel
  %.1281.peel36 = load double, ptr %scevgep295, align 8
  %.1288.peel37 = fdiv double %.1216.1.peel, %.1281.peel36
  store double %.1288.peel37, ptr %lsr.iv299, align 8
  br label %B358.2.peel

B1427.peel38:                                     ; preds = %B460.peel31
  %.1425.peel34 = tail call double @sqrt(double %.1216.1.peel)
  store double %.1425.peel34, ptr %sunkaddr321, align 8
  %exitcond1517.not.peel39 = icmp eq i64 %.28113841413, 2
  br i1 %exitcond1517.not.peel39, label %B542.endif.thread, label %B358.2.peel

B358.2.peel:                                      ; preds = %B1427.peel38.thread, %B1427.peel38
  %.912.peel52 = load double, ptr %sunkaddr366, align 8
  %.967.peel53 = load double, ptr %scevgep310.peel, align 8
  %.970.peel54 = fmul double %.912.peel52, %.967.peel53
  %.972.peel55 = fadd double %.970.peel54, 0.000000e+00
  %.912.1.peel56 = load double, ptr %sunkaddr371, align 8
  %.967.1.peel58 = load double, ptr %scevgep309.peel57, align 8
  %.970.1.peel59 = fmul double %.912.1.peel56, %.967.1.peel58
  %.972.1.peel60 = fadd double %.972.peel55, %.970.1.peel59
  %.912.2.peel61 = load double, ptr %sunkaddr377, align 8
  %.967.2.peel63 = load double, ptr %scevgep308.peel62, align 8
  %.970.2.peel64 = fmul double %.912.2.peel61, %.967.2.peel63
  %.972.2.peel65 = fadd double %.972.1.peel60, %.970.2.peel64
  %.912.3.peel66 = load double, ptr %sunkaddr383, align 8
  %.967.3.peel68 = load double, ptr %scevgep307.peel67, align 8
  %.970.3.peel69 = fmul double %.912.3.peel66, %.967.3.peel68
  %.972.3.peel70 = fadd double %.972.2.peel65, %.970.3.peel69
  %.912.4.peel71 = load double, ptr %sunkaddr389, align 8
  %.967.4.peel73 = load double, ptr %scevgep306.peel72, align 8
  %.970.4.peel74 = fmul double %.912.4.peel71, %.967.4.peel73
  %.972.4.peel75 = fadd double %.972.3.peel70, %.970.4.peel74
  %.912.5.peel76 = load double, ptr %sunkaddr395, align 8
  %.967.5.peel78 = load double, ptr %scevgep305.peel77, align 8
  %.970.5.peel79 = fmul double %.912.5.peel76, %.967.5.peel78
  %.972.5.peel80 = fadd double %.972.4.peel75, %.970.5.peel79
  %.912.6.peel81 = load double, ptr %sunkaddr401, align 8
  %.967.6.peel82 = load double, ptr %lsr.iv303.peel, align 8
  %.970.6.peel83 = fmul double %.912.6.peel81, %.967.6.peel82
  %.972.6.peel84 = fadd double %.972.5.peel80, %.970.6.peel83
  %.1156.peel85 = load double, ptr %sunkaddr406, align 8
  %.1211.peel86 = load double, ptr %scevgep294.peel, align 8
  %.1214.peel87 = fmul double %.1156.peel85, %.1211.peel86
  %.1216.peel88 = fsub double %.972.6.peel84, %.1214.peel87
  %.1156.1.peel89 = load double, ptr %sunkaddr441, align 8
  %.1211.1.peel91 = load double, ptr %scevgep293.peel90, align 8
  %.1214.1.peel92 = fmul double %.1156.1.peel89, %.1211.1.peel91
  %.1216.1.peel93 = fsub double %.1216.peel88, %.1214.1.peel92
  %.1156.2.peel = load double, ptr %sunkaddr312, align 8
  %.1211.2.peel = load double, ptr %scevgep292.peel, align 8
  %.1214.2.peel = fmul double %.1156.2.peel, %.1211.2.peel
  %.1216.2.peel = fsub double %.1216.1.peel93, %.1214.2.peel
  %.1226.peel95 = icmp samesign ugt i64 %.28113841413, 3
  br i1 %.1226.peel95, label %B422.peel100, label %B460.peel96

B460.peel96:                                      ; preds = %B358.2.peel
  %.1353.peel97 = fcmp ogt double %.1216.2.peel, 0.000000e+00
  br i1 %.1353.peel97, label %B500.peel98, label %B472

B500.peel98:                                      ; preds = %B460.peel96
  %.1425.peel99 = tail call double @sqrt(double %.1216.2.peel)
  store double %.1425.peel99, ptr %sunkaddr321, align 8
  br label %B1427.peel103

B422.peel100:                                     ; preds = %B358.2.peel
  %.1281.peel101 = load double, ptr %lsr.iv296.peel, align 8
  %.1288.peel102 = fdiv double %.1216.2.peel, %.1281.peel101
  %scevgep301.peel = getelementptr i8, ptr %lsr.iv299, i64 8
  store double %.1288.peel102, ptr %scevgep301.peel, align 8
  br label %B1427.peel103

B1427.peel103:                                    ; preds = %B422.peel100, %B500.peel98
  %exitcond1517.not.peel104 = icmp eq i64 %.28113841413, 3
  br i1 %exitcond1517.not.peel104, label %B542.endif, label %B358.2

B542.endif.thread:                                ; preds = %B1427.peel38
  %.1791.pre.pre45 = load double, ptr %sunkaddr44344, align 8
  br label %B574.preheader

B542.endif:                                       ; preds = %B1427.peel103, %B1427, %B1427.peel284, %B1427.peel
  %sunkaddr442 = shl i64 %.28113841413, 3
  %sunkaddr443 = getelementptr i8, ptr %arg.out.4, i64 %sunkaddr442
  %.1791.pre.pre = load double, ptr %sunkaddr443, align 8
  br i1 %.1226.peel.not, label %B644, label %B574.preheader

B574.preheader:                                   ; preds = %B542.endif.thread, %B542.endif
  %.1791.pre.pre48 = phi double [ %.1791.pre.pre45, %B542.endif.thread ], [ %.1791.pre.pre, %B542.endif ]
  %sunkaddr44346 = phi ptr [ %sunkaddr44344, %B542.endif.thread ], [ %sunkaddr443, %B542.endif ]
  %sunkaddr444 = shl i64 %.1151, 3
  %sunkaddr445 = getelementptr i8, ptr %arg.L.4, i64 %sunkaddr444
  %.1690 = load double, ptr %sunkaddr445, align 8
  %.1722 = load double, ptr %arg.out.4, align 8
  %.1723 = fmul double %.1690, %.1722
  %.1724 = fsub double %.1791.pre.pre48, %.1723
  store double %.1724, ptr %sunkaddr44346, align 8
  %exitcond1518.not = icmp eq i64 %.28113841413, 1
  br i1 %exitcond1518.not, label %B644, label %B574.1
}

; Function Attrs: mustprogress nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.cos.f64(double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sin.f64(double) #2

; Function Attrs: mustprogress nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #3

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #1 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #2 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { mustprogress nofree nosync nounwind willreturn memory(none) }

!0 = !{!1}
!1 = distinct !{!1, !2, !"part.1: %retptr"}
!2 = distinct !{!2, !"part.1"}
!3 = distinct !{!3, !4}
!4 = !{!"llvm.loop.peeled.count", i32 1}
!5 = distinct !{!5, !6}
!6 = !{!"llvm.loop.peeled.count", i32 4}
