; sha256 7334bae9516ebe3c85df6cd06f06d227272b417d615b9bd2e70c7f198d45f5ca of follow_loops.py and of this
; made by numba 0.68.1, llvmlite 0.50.0, Python 3.11.7
; loops.follow: int64; array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 1d, A); array(float64, 1d, A); float64; float64; array(float64, 2d, A); array(int64, 1d, A)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.follow(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, i64 %arg.slerp, ptr readnone captures(none) %arg.legs.0, ptr readnone captures(none) %arg.legs.1, i64 %arg.legs.2, i64 %arg.legs.3, ptr readonly captures(none) %arg.legs.4, i64 %arg.legs.5.0, i64 %arg.legs.5.1, i64 %arg.legs.6.0, i64 %arg.legs.6.1, ptr readnone captures(none) %arg.rows.0, ptr readnone captures(none) %arg.rows.1, i64 %arg.rows.2, i64 %arg.rows.3, ptr readonly captures(none) %arg.rows.4, i64 %arg.rows.5.0, i64 %arg.rows.5.1, i64 %arg.rows.6.0, i64 %arg.rows.6.1, ptr readnone captures(none) %arg.steps.0, ptr readnone captures(none) %arg.steps.1, i64 %arg.steps.2, i64 %arg.steps.3, ptr readonly captures(none) %arg.steps.4, i64 %arg.steps.5.0, i64 %arg.steps.5.1, i64 %arg.steps.6.0, i64 %arg.steps.6.1, ptr readnone captures(none) %arg.near_end.0, ptr readnone captures(none) %arg.near_end.1, i64 %arg.near_end.2, i64 %arg.near_end.3, ptr readonly captures(none) %arg.near_end.4, i64 %arg.near_end.5.0, i64 %arg.near_end.6.0, ptr readnone captures(none) %arg.left.0, ptr readnone captures(none) %arg.left.1, i64 %arg.left.2, i64 %arg.left.3, ptr readonly captures(none) %arg.left.4, i64 %arg.left.5.0, i64 %arg.left.6.0, double %arg.tolerance, double %arg.turn_tolerance, ptr readnone captures(none) %arg.found.0, ptr readnone captures(none) %arg.found.1, i64 %arg.found.2, i64 %arg.found.3, ptr captures(none) %arg.found.4, i64 %arg.found.5.0, i64 %arg.found.5.1, i64 %arg.found.6.0, i64 %arg.found.6.1, ptr readnone captures(none) %arg.state.0, ptr readnone captures(none) %arg.state.1, i64 %arg.state.2, i64 %arg.state.3, ptr writeonly captures(none) initializes((0, 8)) %arg.state.4, i64 %arg.state.5.0, i64 %arg.state.6.0) local_unnamed_addr #0 {
B0.endif:
  %.670 = alloca [3 x double], align 8
  %.705 = alloca [3 x double], align 8
  %.1839 = alloca [3 x double], align 8
  %.2049 = alloca [3 x double], align 8
  store i64 %arg.rows.5.0, ptr %arg.state.4, align 8
  %.229 = getelementptr i8, ptr %arg.state.4, i64 %arg.state.6.0
  store i64 2, ptr %.229, align 8
  %.arg.rows.5.0 = tail call i64 @llvm.smax.i64(i64 %arg.rows.5.0, i64 0)
  %invariant.gep1657 = getelementptr i8, ptr %arg.found.4, i64 %arg.found.6.1
  %invariant.gep = getelementptr i8, ptr %arg.steps.4, i64 %arg.steps.6.1
  %.963 = mul i64 %arg.legs.6.1, 9
  %invariant.gep1683 = getelementptr i8, ptr %arg.legs.4, i64 %.963
  %.1029 = fmul double %arg.tolerance, 4.000000e+00
  %.1033 = add nsw i64 %arg.legs.5.0, 1
  %.1152 = mul i64 %arg.legs.6.1, 10
  %invariant.gep1685 = getelementptr i8, ptr %arg.legs.4, i64 %.1152
  %.1218 = fmul double %arg.turn_tolerance, 4.000000e+00
  %.1246 = icmp slt i64 %arg.legs.5.0, -1
  %.1247 = select i1 %.1246, i64 %arg.left.5.0, i64 0
  %.1248 = add i64 %.1247, %.1033
  %.1259 = mul i64 %.1248, %arg.left.6.0
  %.1573 = shl i64 %arg.found.6.1, 1
  %invariant.gep1687 = getelementptr i8, ptr %arg.found.4, i64 %.1573
  %.1628 = mul i64 %arg.found.6.1, 3
  %invariant.gep1689 = getelementptr i8, ptr %arg.found.4, i64 %.1628
  %.1657 = fmul double %arg.tolerance, 3.000000e+00
  %.1682 = fmul double %arg.turn_tolerance, 3.000000e+00
  %.2471 = mul i64 %arg.legs.6.1, 3
  %.2657 = mul i64 %arg.legs.6.1, 5
  %.2732 = mul i64 %arg.legs.6.1, 6
  %.2767 = mul i64 %arg.legs.6.1, 7
  %sunkaddr = getelementptr inbounds nuw i8, ptr %.670, i64 16
  %sunkaddr433 = getelementptr inbounds nuw i8, ptr %.670, i64 8
  %sunkaddr434 = getelementptr inbounds nuw i8, ptr %.705, i64 8
  %sunkaddr441 = getelementptr i8, ptr %arg.left.4, i64 %.1259
  %0 = add i64 %arg.legs.5.0, 2
  %1 = fcmp ult double %.1682, 0.000000e+00
  %2 = fcmp ult double %.1657, 0.000000e+00
  %sunkaddr450 = getelementptr inbounds nuw i8, ptr %.1839, i64 8
  %sunkaddr451 = getelementptr inbounds nuw i8, ptr %.1839, i64 16
  %sunkaddr452 = getelementptr inbounds nuw i8, ptr %.2049, i64 16
  %sunkaddr453 = getelementptr inbounds nuw i8, ptr %.2049, i64 8
  %sunkaddr454 = shl i64 %arg.legs.6.1, 2
  %sunkaddr457 = shl i64 %arg.legs.6.1, 1
  %sunkaddr459 = shl i64 %arg.rows.6.1, 1
  %sunkaddr461 = shl i64 %arg.legs.6.1, 3
  br label %B148

B148:                                             ; preds = %B1806, %B0.endif
  %.3331671 = phi i64 [ 0, %B0.endif ], [ %.340, %B1806 ]
  %share.2.0 = phi double [ 0.000000e+00, %B0.endif ], [ %.776.lcssa1722, %B1806 ]
  %at.2.0 = phi i64 [ 0, %B0.endif ], [ %i.4.1.lcssa1715, %B1806 ]
  %exitcond.not = icmp eq i64 %.3331671, %.arg.rows.5.0
  br i1 %exitcond.not, label %common.ret.sink.split, label %B150

B150:                                             ; preds = %B148
  %.340 = add nuw i64 %.3331671, 1
  %.489 = mul i64 %.3331671, %arg.rows.6.0
  %.491 = getelementptr i8, ptr %arg.rows.4, i64 %.489
  %.863 = icmp slt i64 %at.2.0, 0
  %.942 = select i1 %.863, i64 %arg.legs.5.0, i64 0
  %.943 = add i64 %.942, %at.2.0
  %.962 = mul i64 %.943, %arg.legs.6.0
  %.419.peel = getelementptr i8, ptr %arg.legs.4, i64 %.962
  call fastcc void @part.0(ptr nonnull %.670, i64 %arg.slerp, ptr %.419.peel, i64 %arg.legs.6.1, ptr %.491, i64 %arg.rows.6.1)
  %.688.fca.2.load.peel = load double, ptr %sunkaddr, align 8
  %.688.fca.1.load.peel = load double, ptr %sunkaddr433, align 8
  %.688.fca.0.load.peel = load double, ptr %.670, align 8
  call fastcc void @part.1(ptr nonnull %.705, ptr %.419.peel, i64 %arg.legs.6.1, ptr %.491, i64 %arg.rows.6.1, double %.688.fca.0.load.peel, double %.688.fca.1.load.peel, double %.688.fca.2.load.peel, double %arg.tolerance)
  %.726.fca.1.load.peel = load double, ptr %sunkaddr434, align 8
  %.726.fca.0.load.peel = load double, ptr %.705, align 8
  %.12.i = fcmp ogt double %.726.fca.0.load.peel, %share.2.0
  %.13.i = select i1 %.12.i, double %.726.fca.0.load.peel, double %share.2.0
  %.12.i153 = fcmp olt double %.726.fca.1.load.peel, 1.000000e+00
  %.13.i154 = select i1 %.12.i153, double %.726.fca.1.load.peel, double 1.000000e+00
  %.820.peel = fcmp ugt double %.13.i, %.13.i154
  br i1 %.820.peel, label %B370.peel, label %B718

B370.peel:                                        ; preds = %B150
  %.1035 = add nsw i64 %at.2.0, %.1033
  %.1049 = icmp slt i64 %.1035, 0
  %.1050 = select i1 %.1049, i64 %arg.left.5.0, i64 0
  %.1051 = add i64 %.1050, %.1035
  %.1062 = mul i64 %.1051, %arg.left.6.0
  %.1017 = mul i64 %.3331671, %arg.steps.6.0
  %.864 = select i1 %.863, i64 %arg.left.5.0, i64 0
  %.865 = add i64 %.864, %at.2.0
  %.876 = mul i64 %.865, %arg.left.6.0
  %.840.peel = add nsw i64 %at.2.0, 1
  %sunkaddr435 = getelementptr i8, ptr %arg.left.4, i64 %.876
  %.880.peel = load double, ptr %sunkaddr435, align 8
  %.895.peel = icmp slt i64 %at.2.0, -1
  %.896.peel = select i1 %.895.peel, i64 %arg.left.5.0, i64 0
  %.897.peel = add i64 %.896.peel, %.840.peel
  %.908.peel = mul i64 %.897.peel, %arg.left.6.0
  %.910.peel = getelementptr i8, ptr %arg.left.4, i64 %.908.peel
  %.912.peel = load double, ptr %.910.peel, align 8
  %.913.peel = fsub double %.880.peel, %.912.peel
  %sunkaddr436 = getelementptr i8, ptr %invariant.gep1683, i64 %.962
  %.968.peel = load double, ptr %sunkaddr436, align 8
  %sunkaddr437 = getelementptr i8, ptr %arg.steps.4, i64 %.1017
  %.1023.peel = load double, ptr %sunkaddr437, align 8
  %.1025.peel = fmul double %.1023.peel, 2.000000e+00
  %.1026.peel = fadd double %.968.peel, %.1025.peel
  %.1030.peel = fadd double %.1029, %.1026.peel
  %.1031.peel = fcmp ogt double %.913.peel, %.1030.peel
  %sunkaddr438 = getelementptr i8, ptr %arg.left.4, i64 %.1062
  %.1066.peel = load double, ptr %sunkaddr438, align 8
  %.1070.peel = add nsw i64 %.840.peel, %.1033
  %.1084.peel = icmp slt i64 %.1070.peel, 0
  %.1085.peel = select i1 %.1084.peel, i64 %arg.left.5.0, i64 0
  %.1086.peel = add i64 %.1085.peel, %.1070.peel
  %.1097.peel = mul i64 %.1086.peel, %arg.left.6.0
  %.1099.peel = getelementptr i8, ptr %arg.left.4, i64 %.1097.peel
  %.1101.peel = load double, ptr %.1099.peel, align 8
  %.1102.peel = fsub double %.1066.peel, %.1101.peel
  %sunkaddr439 = getelementptr i8, ptr %invariant.gep1685, i64 %.962
  %.1157.peel = load double, ptr %sunkaddr439, align 8
  %sunkaddr440 = getelementptr i8, ptr %invariant.gep, i64 %.1017
  %.1212.peel = load double, ptr %sunkaddr440, align 8
  %.1214.peel = fmul double %.1212.peel, 2.000000e+00
  %.1215.peel = fadd double %.1157.peel, %.1214.peel
  %.1219.peel = fadd double %.1218, %.1215.peel
  %3 = fcmp ogt double %.1102.peel, %.1219.peel
  br i1 %.1031.peel, label %B608.peel, label %B642.peel

B642.peel:                                        ; preds = %B370.peel
  br i1 %3, label %B646.peel, label %B668.peel

B646.peel:                                        ; preds = %B642.peel
  %.1306.peel = load double, ptr %arg.left.4, align 8
  %.1308.peel = fcmp oeq double %.1306.peel, 0.000000e+00
  br label %B668.peel

B608.peel:                                        ; preds = %B370.peel
  br i1 %3, label %common.ret.sink.split.sink.split, label %B612.peel

B612.peel:                                        ; preds = %B608.peel
  %.1263.peel = load double, ptr %sunkaddr441, align 8
  %.1265.peel = fcmp oeq double %.1263.peel, 0.000000e+00
  br i1 %.1265.peel, label %common.ret.sink.split.sink.split, label %B668.peel

B668.peel:                                        ; preds = %B612.peel, %B646.peel, %B642.peel
  %"$phi668.1.4.3.peel" = phi i1 [ false, %B642.peel ], [ %.1308.peel, %B646.peel ], [ false, %B612.peel ]
  %.1322.peel = icmp eq i64 %.840.peel, %arg.legs.5.0
  %brmerge.peel = select i1 %.1322.peel, i1 true, i1 %"$phi668.1.4.3.peel"
  br i1 %brmerge.peel, label %common.ret.sink.split.sink.split, label %B162

B162:                                             ; preds = %B668.peel, %B668
  %i.4.1 = phi i64 [ %4, %B668 ], [ %.840.peel, %B668.peel ]
  %.399 = icmp slt i64 %i.4.1, 0
  %.400 = select i1 %.399, i64 %arg.legs.5.0, i64 0
  %.401 = add i64 %.400, %i.4.1
  %.417 = mul i64 %.401, %arg.legs.6.0
  %.419 = getelementptr i8, ptr %arg.legs.4, i64 %.417
  call fastcc void @part.0(ptr nonnull %.670, i64 %arg.slerp, ptr %.419, i64 %arg.legs.6.1, ptr %.491, i64 %arg.rows.6.1)
  %.688.fca.2.load = load double, ptr %sunkaddr, align 8
  %.688.fca.1.load = load double, ptr %sunkaddr433, align 8
  %.688.fca.0.load = load double, ptr %.670, align 8
  call fastcc void @part.1(ptr nonnull %.705, ptr %.419, i64 %arg.legs.6.1, ptr %.491, i64 %arg.rows.6.1, double %.688.fca.0.load, double %.688.fca.1.load, double %.688.fca.2.load, double %arg.tolerance)
  %.726.fca.1.load = load double, ptr %sunkaddr434, align 8
  %.726.fca.0.load = load double, ptr %.705, align 8
  %.12.i157 = fcmp ogt double %.726.fca.0.load, 0.000000e+00
  %.13.i158 = select i1 %.12.i157, double %.726.fca.0.load, double 0.000000e+00
  %.12.i159 = fcmp olt double %.726.fca.1.load, 1.000000e+00
  %.13.i160 = select i1 %.12.i159, double %.726.fca.1.load, double 1.000000e+00
  %.820 = fcmp ugt double %.13.i158, %.13.i160
  br i1 %.820, label %B370, label %B718

B370:                                             ; preds = %B162
  %reass.sub = sub i64 %i.4.1, %arg.legs.5.0
  %.895 = icmp slt i64 %i.4.1, -1
  %.896 = select i1 %.895, i64 %arg.left.5.0, i64 0
  %4 = add i64 %i.4.1, 1
  %5 = add i64 %4, %.896
  %.908 = mul i64 %5, %arg.left.6.0
  %.910 = getelementptr i8, ptr %arg.left.4, i64 %.908
  %.912 = load double, ptr %.910, align 8
  %.913 = fsub double %.880.peel, %.912
  %.1031 = fcmp ogt double %.913, %.1030.peel
  %6 = add i64 %0, %i.4.1
  %.1084 = icmp slt i64 %6, 0
  %.1085 = select i1 %.1084, i64 %arg.left.5.0, i64 0
  %7 = add i64 %6, %.1085
  %.1097 = mul i64 %7, %arg.left.6.0
  %.1099 = getelementptr i8, ptr %arg.left.4, i64 %.1097
  %.1101 = load double, ptr %.1099, align 8
  %.1102 = fsub double %.1066.peel, %.1101
  %8 = fcmp ogt double %.1102, %.1219.peel
  br i1 %.1031, label %B608, label %B642

B608:                                             ; preds = %B370
  br i1 %8, label %common.ret.sink.split.sink.split, label %B612

B612:                                             ; preds = %B608
  %.1263 = load double, ptr %sunkaddr441, align 8
  %.1265 = fcmp oeq double %.1263, 0.000000e+00
  br i1 %.1265, label %common.ret.sink.split.sink.split, label %B668

B642:                                             ; preds = %B370
  br i1 %8, label %B646, label %B668

B646:                                             ; preds = %B642
  %.1306 = load double, ptr %arg.left.4, align 8
  %.1308 = fcmp oeq double %.1306, 0.000000e+00
  br label %B668

B668:                                             ; preds = %B646, %B642, %B612
  %"$phi668.1.4.3" = phi i1 [ false, %B642 ], [ %.1308, %B646 ], [ false, %B612 ]
  %.1322 = icmp eq i64 %reass.sub, -1
  %brmerge = select i1 %.1322, i1 true, i1 %"$phi668.1.4.3"
  br i1 %brmerge, label %common.ret.sink.split.sink.split, label %B162, !llvm.loop !0

common.ret.sink.split.sink.split:                 ; preds = %B1806, %B608.peel, %B612.peel, %B668.peel, %B608, %B612, %B668
  %.340.lcssa36.sink = phi i64 [ %.3331671, %B608 ], [ %.3331671, %B668 ], [ %.3331671, %B612 ], [ %.340, %B1806 ], [ %.3331671, %B668.peel ], [ %.3331671, %B608.peel ], [ %.3331671, %B612.peel ]
  %.sink = phi i64 [ 1, %B608 ], [ 1, %B668 ], [ 1, %B612 ], [ 0, %B1806 ], [ 1, %B668.peel ], [ 1, %B608.peel ], [ 1, %B612.peel ]
  store i64 %.340.lcssa36.sink, ptr %arg.state.4, align 8
  store i64 %.sink, ptr %.229, align 8
  br label %common.ret.sink.split

common.ret.sink.split:                            ; preds = %B148, %common.ret.sink.split.sink.split
  store ptr null, ptr %retptr, align 8
  ret i32 0

B718:                                             ; preds = %B162, %B150
  %.776.lcssa1722 = phi double [ %.13.i, %B150 ], [ %.13.i158, %B162 ]
  %i.4.1.lcssa1715 = phi i64 [ %at.2.0, %B150 ], [ %i.4.1, %B162 ]
  %.399.lcssa1710 = phi i1 [ %.863, %B150 ], [ %.399, %B162 ]
  %.417.lcssa1705 = phi i64 [ %.962, %B150 ], [ %.417, %B162 ]
  %.1516 = mul i64 %.3331671, %arg.found.6.0
  %.1520 = getelementptr i8, ptr %arg.found.4, i64 %.1516
  %.1522 = sitofp i64 %i.4.1.lcssa1715 to double
  store double %.1522, ptr %.1520, align 8
  %gep1688 = getelementptr i8, ptr %invariant.gep1687, i64 %.1516
  store double 0x7FF0000000000000, ptr %gep1688, align 8
  %gep1690 = getelementptr i8, ptr %invariant.gep1689, i64 %.1516
  store double 0x7FF0000000000000, ptr %gep1690, align 8
  %.1650 = icmp sge i64 %i.4.1.lcssa1715, %arg.legs.5.0
  %brmerge1695 = select i1 %.1650, i1 true, i1 %2
  %brmerge1696 = select i1 %brmerge1695, i1 true, i1 %1
  br i1 %brmerge1696, label %B1806, label %B848.preheader

B848.preheader:                                   ; preds = %B718
  %.1713.peel = icmp slt i64 %i.4.1.lcssa1715, 0
  %.1714.peel = select i1 %.1713.peel, i64 %arg.legs.5.0, i64 0
  %.1715.peel = add i64 %.1714.peel, %i.4.1.lcssa1715
  %.1731.peel = mul i64 %.1715.peel, %arg.legs.6.0
  %.1733.peel = getelementptr i8, ptr %arg.legs.4, i64 %.1731.peel
  call fastcc void @part.0(ptr nonnull %.1839, i64 %arg.slerp, ptr %.1733.peel, i64 %arg.legs.6.1, ptr %.491, i64 %arg.rows.6.1)
  %.1857.fca.0.load.peel = load double, ptr %.1839, align 8
  %.1857.fca.1.load.peel = load double, ptr %sunkaddr450, align 8
  %.1857.fca.2.load.peel = load double, ptr %sunkaddr451, align 8
  call fastcc void @part.1(ptr nonnull %.2049, ptr %.1733.peel, i64 %arg.legs.6.1, ptr %.491, i64 %arg.rows.6.1, double %.1857.fca.0.load.peel, double %.1857.fca.1.load.peel, double %.1857.fca.2.load.peel, double %arg.tolerance)
  %.2070.fca.1.load.peel = load double, ptr %sunkaddr453, align 8
  %.2070.fca.0.load.peel = load double, ptr %.2049, align 8
  %.12.i161.peel = fcmp ogt double %.2070.fca.0.load.peel, %.776.lcssa1722
  %.13.i162.peel = select i1 %.12.i161.peel, double %.2070.fca.0.load.peel, double %.776.lcssa1722
  %.12.i163.peel = fcmp olt double %.2070.fca.1.load.peel, 1.000000e+00
  %.13.i164.peel = select i1 %.12.i163.peel, double %.2070.fca.1.load.peel, double 1.000000e+00
  %.2199.peel = fcmp ugt double %.13.i162.peel, %.13.i164.peel
  br i1 %.2199.peel, label %B1670.peel, label %B1086.endif.endif.peel

B1086.endif.endif.peel:                           ; preds = %B848.preheader
  %.2070.fca.2.load.peel = load double, ptr %sunkaddr452, align 8
  %.12.i155.peel = fcmp ogt double %.13.i162.peel, %.2070.fca.2.load.peel
  %.13.i156.peel = select i1 %.12.i155.peel, double %.13.i162.peel, double %.2070.fca.2.load.peel
  %.12.i165.peel = fcmp olt double %.13.i164.peel, %.13.i156.peel
  %.13.i166.peel = select i1 %.12.i165.peel, double %.13.i164.peel, double %.13.i156.peel
  %.2445.peel = load double, ptr %.1733.peel, align 8
  %.2473.peel = getelementptr i8, ptr %.1733.peel, i64 %.2471
  %.2475.peel = load double, ptr %.2473.peel, align 8
  %.2476.peel = fmul double %.2475.peel, %.13.i166.peel
  %.2477.peel = fadd double %.2445.peel, %.2476.peel
  %.2507.peel = load double, ptr %.491, align 8
  %.2508.peel = fsub double %.2477.peel, %.2507.peel
  %.2536.peel = getelementptr i8, ptr %.1733.peel, i64 %arg.legs.6.1
  %.2538.peel = load double, ptr %.2536.peel, align 8
  %sunkaddr455 = getelementptr i8, ptr %.1733.peel, i64 %sunkaddr454
  %.2568.peel = load double, ptr %sunkaddr455, align 8
  %.2569.peel = fmul double %.13.i166.peel, %.2568.peel
  %.2570.peel = fadd double %.2538.peel, %.2569.peel
  %sunkaddr456 = getelementptr i8, ptr %.491, i64 %arg.rows.6.1
  %.2600.peel = load double, ptr %sunkaddr456, align 8
  %.2601.peel = fsub double %.2570.peel, %.2600.peel
  %sunkaddr458 = getelementptr i8, ptr %.1733.peel, i64 %sunkaddr457
  %.2631.peel = load double, ptr %sunkaddr458, align 8
  %.2659.peel = getelementptr i8, ptr %.1733.peel, i64 %.2657
  %.2661.peel = load double, ptr %.2659.peel, align 8
  %.2662.peel = fmul double %.13.i166.peel, %.2661.peel
  %.2663.peel = fadd double %.2631.peel, %.2662.peel
  %sunkaddr460 = getelementptr i8, ptr %.491, i64 %sunkaddr459
  %.2693.peel = load double, ptr %sunkaddr460, align 8
  %.2697.peel = fsub double %.2663.peel, %.2693.peel
  %.2698.peel = fmul double %.2508.peel, %.2508.peel
  %.2699.peel = fmul double %.2601.peel, %.2601.peel
  %.2700.peel = fadd double %.2698.peel, %.2699.peel
  %.2701.peel = fmul double %.2697.peel, %.2697.peel
  %.2702.peel = fadd double %.2700.peel, %.2701.peel
  %sqrt1580.peel = tail call double @llvm.sqrt.f64(double %.2702.peel)
  %.2734.peel = getelementptr i8, ptr %.1733.peel, i64 %.2732
  %.2736.peel = load double, ptr %.2734.peel, align 8
  %.2737.peel = fmul double %.13.i166.peel, %.2736.peel
  %.2739.peel = fsub double %.2737.peel, %.1857.fca.0.load.peel
  %.2769.peel = getelementptr i8, ptr %.1733.peel, i64 %.2767
  %.2771.peel = load double, ptr %.2769.peel, align 8
  %.2772.peel = fmul double %.13.i166.peel, %.2771.peel
  %.2774.peel = fsub double %.2772.peel, %.1857.fca.1.load.peel
  %sunkaddr462 = getelementptr i8, ptr %.1733.peel, i64 %sunkaddr461
  %.2806.peel = load double, ptr %sunkaddr462, align 8
  %.2810.peel = fmul double %.13.i166.peel, %.2806.peel
  %.2812.peel = fsub double %.2810.peel, %.1857.fca.2.load.peel
  %.2815.peel = fmul double %.2739.peel, %.2739.peel
  %.2816.peel = fmul double %.2774.peel, %.2774.peel
  %.2817.peel = fadd double %.2815.peel, %.2816.peel
  %.2818.peel = fmul double %.2812.peel, %.2812.peel
  %.2819.peel = fadd double %.2817.peel, %.2818.peel
  %sqrt.peel = tail call double @llvm.sqrt.f64(double %.2819.peel)
  %.2878.peel = load double, ptr %gep1688, align 8
  %.2880.peel = fcmp olt double %sqrt1580.peel, %.2878.peel
  br i1 %.2880.peel, label %B1640.peel, label %B1584.peel

B1584.peel:                                       ; preds = %B1086.endif.endif.peel
  %.2938.peel = fcmp oeq double %sqrt1580.peel, %.2878.peel
  %.2996.peel = fcmp one double %sqrt.peel, 0x7FF0000000000000
  %or.cond1 = select i1 %.2938.peel, i1 %.2996.peel, i1 false
  br i1 %or.cond1, label %B1640.peel, label %B1670.peel

B1640.peel:                                       ; preds = %B1584.peel, %B1086.endif.endif.peel
  store double %sqrt1580.peel, ptr %gep1688, align 8
  store double %sqrt.peel, ptr %gep1690, align 8
  br label %B1670.peel

B1670.peel:                                       ; preds = %B1640.peel, %B1584.peel, %B848.preheader
  %.299426 = phi double [ %sqrt.peel, %B1640.peel ], [ 0x7FF0000000000000, %B1584.peel ], [ 0x7FF0000000000000, %B848.preheader ]
  %.3133.peel = fsub double 1.000000e+00, %.776.lcssa1722
  %gep1654.peel = getelementptr i8, ptr %invariant.gep1683, i64 %.1731.peel
  %.3188.peel = load double, ptr %gep1654.peel, align 8
  %.3189.peel = fmul double %.3133.peel, %.3188.peel
  %gep1656.peel = getelementptr i8, ptr %invariant.gep1685, i64 %.1731.peel
  %.3253.peel = load double, ptr %gep1656.peel, align 8
  %.3254.peel = fmul double %.3133.peel, %.3253.peel
  %.3266.peel = add nsw i64 %i.4.1.lcssa1715, 1
  %.3277.peel = icmp slt i64 %.3266.peel, %arg.legs.5.0
  %.3286.peel = fcmp ole double %.3189.peel, %.1657
  %or.cond.peel = select i1 %.3277.peel, i1 %.3286.peel, i1 false
  %.3308.peel = fcmp ole double %.3254.peel, %.1682
  %or.cond1577.peel = select i1 %or.cond.peel, i1 %.3308.peel, i1 false
  br i1 %or.cond1577.peel, label %B848.peel.next, label %B1806

B848.peel.next:                                   ; preds = %B1670.peel
  %.3256.peel = fadd double %.3254.peel, 0.000000e+00
  %.3191.peel = fadd double %.3189.peel, 0.000000e+00
  %sunkaddr480 = getelementptr i8, ptr %.491, i64 %arg.rows.6.1
  %sunkaddr484 = getelementptr i8, ptr %.491, i64 %sunkaddr459
  br label %B848

B848:                                             ; preds = %B1670, %B848.peel.next
  %.2994 = phi double [ %.299426, %B848.peel.next ], [ %.299425, %B1670 ]
  %lsr.iv = phi i64 [ -1, %B848.peel.next ], [ %math, %B1670 ]
  %i.5.2 = phi i64 [ %.3266.peel, %B848.peel.next ], [ %.3266, %B1670 ]
  %turn.2.2 = phi double [ %.3256.peel, %B848.peel.next ], [ %.3256, %B1670 ]
  %way.2.2 = phi double [ %.3191.peel, %B848.peel.next ], [ %.3191, %B1670 ]
  %.1713 = icmp slt i64 %i.5.2, 0
  %.1714 = select i1 %.1713, i64 %arg.legs.5.0, i64 0
  %.1715 = add i64 %.1714, %i.5.2
  %.1731 = mul i64 %.1715, %arg.legs.6.0
  %.1733 = getelementptr i8, ptr %arg.legs.4, i64 %.1731
  call fastcc void @part.0(ptr nonnull %.1839, i64 %arg.slerp, ptr %.1733, i64 %arg.legs.6.1, ptr %.491, i64 %arg.rows.6.1)
  %.1857.fca.0.load = load double, ptr %.1839, align 8
  %.1857.fca.1.load = load double, ptr %sunkaddr450, align 8
  %.1857.fca.2.load = load double, ptr %sunkaddr451, align 8
  call fastcc void @part.1(ptr nonnull %.2049, ptr %.1733, i64 %arg.legs.6.1, ptr %.491, i64 %arg.rows.6.1, double %.1857.fca.0.load, double %.1857.fca.1.load, double %.1857.fca.2.load, double %arg.tolerance)
  %.2070.fca.1.load = load double, ptr %sunkaddr453, align 8
  %.2070.fca.0.load = load double, ptr %.2049, align 8
  %9 = tail call { i64, i1 } @llvm.usub.with.overflow.i64(i64 %lsr.iv, i64 1)
  %math = extractvalue { i64, i1 } %9, 0
  %ov = extractvalue { i64, i1 } %9, 1
  %"$phi1006.1.2.3" = select i1 %ov, double %.776.lcssa1722, double 0.000000e+00
  %.12.i161 = fcmp ogt double %.2070.fca.0.load, %"$phi1006.1.2.3"
  %.13.i162 = select i1 %.12.i161, double %.2070.fca.0.load, double %"$phi1006.1.2.3"
  %.12.i163 = fcmp olt double %.2070.fca.1.load, 1.000000e+00
  %.13.i164 = select i1 %.12.i163, double %.2070.fca.1.load, double 1.000000e+00
  %.2199 = fcmp ugt double %.13.i162, %.13.i164
  br i1 %.2199, label %B1670, label %B1086.endif.endif

B1584:                                            ; preds = %B1086.endif.endif
  %.2938 = fcmp oeq double %sqrt1580, %.2878
  %.2996 = fcmp olt double %sqrt, %.2994
  %or.cond38 = select i1 %.2938, i1 %.2996, i1 false
  br i1 %or.cond38, label %B1640, label %B1670

B1640:                                            ; preds = %B1584, %B1086.endif.endif
  store double %sqrt1580, ptr %gep1688, align 8
  store double %sqrt, ptr %gep1690, align 8
  br label %B1670

B1670:                                            ; preds = %B848, %B1640, %B1584
  %.299425 = phi double [ %.2994, %B848 ], [ %sqrt, %B1640 ], [ %.2994, %B1584 ]
  %.3133 = fsub double 1.000000e+00, %"$phi1006.1.2.3"
  %gep1654 = getelementptr i8, ptr %invariant.gep1683, i64 %.1731
  %.3188 = load double, ptr %gep1654, align 8
  %.3189 = fmul double %.3133, %.3188
  %.3191 = fadd double %way.2.2, %.3189
  %gep1656 = getelementptr i8, ptr %invariant.gep1685, i64 %.1731
  %.3253 = load double, ptr %gep1656, align 8
  %.3254 = fmul double %.3133, %.3253
  %.3256 = fadd double %turn.2.2, %.3254
  %.3266 = add nsw i64 %i.5.2, 1
  %.3277 = icmp slt i64 %.3266, %arg.legs.5.0
  %.3286 = fcmp ole double %.3191, %.1657
  %or.cond = select i1 %.3277, i1 %.3286, i1 false
  %.3308 = fcmp ole double %.3256, %.1682
  %or.cond1577 = select i1 %or.cond, i1 %.3308, i1 false
  br i1 %or.cond1577, label %B848, label %B1806, !llvm.loop !2

B1806:                                            ; preds = %B1670, %B1670.peel, %B718
  %i.6.1 = phi i64 [ %i.4.1.lcssa1715, %B718 ], [ %.3266.peel, %B1670.peel ], [ %.3266, %B1670 ]
  %.3336 = add nsw i64 %i.6.1, -1
  %gep1658 = getelementptr i8, ptr %invariant.gep1657, i64 %.1516
  %.3393 = sitofp i64 %.3336 to double
  store double %.3393, ptr %gep1658, align 8
  %.3410 = select i1 %.399.lcssa1710, i64 %arg.left.5.0, i64 0
  %.3411 = add i64 %.3410, %i.4.1.lcssa1715
  %.3422 = mul i64 %.3411, %arg.left.6.0
  %.3424 = getelementptr i8, ptr %arg.left.4, i64 %.3422
  %.3426 = load double, ptr %.3424, align 8
  %gep1692 = getelementptr i8, ptr %invariant.gep1683, i64 %.417.lcssa1705
  %.3481 = load double, ptr %gep1692, align 8
  %.3483 = fmul double %.776.lcssa1722, %.3481
  %.3484 = fsub double %.3426, %.3483
  %.3488 = add nsw i64 %i.4.1.lcssa1715, %.1033
  %.3502 = icmp slt i64 %.3488, 0
  %.3503 = select i1 %.3502, i64 %arg.left.5.0, i64 0
  %.3504 = add i64 %.3503, %.3488
  %.3515 = mul i64 %.3504, %arg.left.6.0
  %.3517 = getelementptr i8, ptr %arg.left.4, i64 %.3515
  %.3519 = load double, ptr %.3517, align 8
  %gep1694 = getelementptr i8, ptr %invariant.gep1685, i64 %.417.lcssa1705
  %.3574 = load double, ptr %gep1694, align 8
  %.3576 = fmul double %.776.lcssa1722, %.3574
  %.3577 = fsub double %.3519, %.3576
  %.3611 = mul i64 %.3331671, %arg.near_end.6.0
  %.3613 = getelementptr i8, ptr %arg.near_end.4, i64 %.3611
  %.3615 = load double, ptr %.3613, align 8
  %.3617 = fcmp ole double %.3615, 0.000000e+00
  %.3623 = fcmp ole double %.3484, %.1029
  %or.cond1578 = select i1 %.3617, i1 %.3623, i1 false
  %.3631 = fcmp ole double %.3577, %.1218
  %or.cond1579 = select i1 %or.cond1578, i1 %.3631, i1 false
  br i1 %or.cond1579, label %common.ret.sink.split.sink.split, label %B148

B1086.endif.endif:                                ; preds = %B848
  %.2070.fca.2.load = load double, ptr %sunkaddr452, align 8
  %.12.i155 = fcmp ogt double %.13.i162, %.2070.fca.2.load
  %.13.i156 = select i1 %.12.i155, double %.13.i162, double %.2070.fca.2.load
  %.12.i165 = fcmp olt double %.13.i164, %.13.i156
  %.13.i166 = select i1 %.12.i165, double %.13.i164, double %.13.i156
  %.2445 = load double, ptr %.1733, align 8
  %.2473 = getelementptr i8, ptr %.1733, i64 %.2471
  %.2475 = load double, ptr %.2473, align 8
  %.2476 = fmul double %.2475, %.13.i166
  %.2477 = fadd double %.2445, %.2476
  %.2507 = load double, ptr %.491, align 8
  %.2508 = fsub double %.2477, %.2507
  %.2536 = getelementptr i8, ptr %.1733, i64 %arg.legs.6.1
  %.2538 = load double, ptr %.2536, align 8
  %sunkaddr479 = getelementptr i8, ptr %.1733, i64 %sunkaddr454
  %.2568 = load double, ptr %sunkaddr479, align 8
  %.2569 = fmul double %.13.i166, %.2568
  %.2570 = fadd double %.2538, %.2569
  %.2600 = load double, ptr %sunkaddr480, align 8
  %.2601 = fsub double %.2570, %.2600
  %sunkaddr482 = getelementptr i8, ptr %.1733, i64 %sunkaddr457
  %.2631 = load double, ptr %sunkaddr482, align 8
  %.2659 = getelementptr i8, ptr %.1733, i64 %.2657
  %.2661 = load double, ptr %.2659, align 8
  %.2662 = fmul double %.13.i166, %.2661
  %.2663 = fadd double %.2631, %.2662
  %.2693 = load double, ptr %sunkaddr484, align 8
  %.2697 = fsub double %.2663, %.2693
  %.2698 = fmul double %.2508, %.2508
  %.2699 = fmul double %.2601, %.2601
  %.2700 = fadd double %.2698, %.2699
  %.2701 = fmul double %.2697, %.2697
  %.2702 = fadd double %.2700, %.2701
  %sqrt1580 = tail call double @llvm.sqrt.f64(double %.2702)
  %.2734 = getelementptr i8, ptr %.1733, i64 %.2732
  %.2736 = load double, ptr %.2734, align 8
  %.2737 = fmul double %.13.i166, %.2736
  %.2739 = fsub double %.2737, %.1857.fca.0.load
  %.2769 = getelementptr i8, ptr %.1733, i64 %.2767
  %.2771 = load double, ptr %.2769, align 8
  %.2772 = fmul double %.13.i166, %.2771
  %.2774 = fsub double %.2772, %.1857.fca.1.load
  %sunkaddr486 = getelementptr i8, ptr %.1733, i64 %sunkaddr461
  %.2806 = load double, ptr %sunkaddr486, align 8
  %.2810 = fmul double %.13.i166, %.2806
  %.2812 = fsub double %.2810, %.1857.fca.2.load
  %.2815 = fmul double %.2739, %.2739
  %.2816 = fmul double %.2774, %.2774
  %.2817 = fadd double %.2815, %.2816
  %.2818 = fmul double %.2812, %.2812
  %.2819 = fadd double %.2817, %.2818
  %sqrt = tail call double @llvm.sqrt.f64(double %.2819)
  %.2878 = load double, ptr %gep1688, align 8
  %.2880 = fcmp olt double %sqrt1580, %.2878
  br i1 %.2880, label %B1640, label %B1584
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #1

; Function Attrs: mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite)
define internal fastcc void @part.0(ptr noalias nonnull writeonly captures(none) initializes((0, 24)) %retptr, i64 %arg.slerp, ptr readonly captures(none) %arg.leg.4, i64 %arg.leg.6.0, ptr readonly captures(none) %arg.row.4, i64 %arg.row.6.0) unnamed_addr #2 {
B0:
  %.33 = icmp eq i64 %arg.slerp, 0
  br i1 %.33, label %B16, label %B116

common.ret:                                       ; preds = %B608, %B16
  %.695.sink = phi double [ %.695, %B608 ], [ %.97, %B16 ]
  %.699.sink = phi double [ %.699, %B608 ], [ %.160, %B16 ]
  %.703.sink = phi double [ %.703, %B608 ], [ %.233, %B16 ]
  store double %.695.sink, ptr %retptr, align 8
  %retptr.repack219 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store double %.699.sink, ptr %retptr.repack219, align 8
  %retptr.repack221 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store double %.703.sink, ptr %retptr.repack221, align 8
  ret void

B16:                                              ; preds = %B0
  %.61 = mul i64 %arg.row.6.0, 3
  %.63 = getelementptr i8, ptr %arg.row.4, i64 %.61
  %.65 = load double, ptr %.63, align 8
  %.92 = mul i64 %arg.leg.6.0, 12
  %.94 = getelementptr i8, ptr %arg.leg.4, i64 %.92
  %.96 = load double, ptr %.94, align 8
  %.97 = fsub double %.65, %.96
  %.124 = shl i64 %arg.row.6.0, 2
  %.126 = getelementptr i8, ptr %arg.row.4, i64 %.124
  %.128 = load double, ptr %.126, align 8
  %.155 = mul i64 %arg.leg.6.0, 13
  %.157 = getelementptr i8, ptr %arg.leg.4, i64 %.155
  %.159 = load double, ptr %.157, align 8
  %.160 = fsub double %.128, %.159
  %.187 = mul i64 %arg.row.6.0, 5
  %.189 = getelementptr i8, ptr %arg.row.4, i64 %.187
  %.191 = load double, ptr %.189, align 8
  %.223 = mul i64 %arg.leg.6.0, 14
  %.225 = getelementptr i8, ptr %arg.leg.4, i64 %.223
  %.227 = load double, ptr %.225, align 8
  %.233 = fsub double %.191, %.227
  br label %common.ret

B116:                                             ; preds = %B0
  %.274 = mul i64 %arg.leg.6.0, 12
  %.276 = getelementptr i8, ptr %arg.leg.4, i64 %.274
  %.278 = load double, ptr %.276, align 8
  %.305 = mul i64 %arg.leg.6.0, 13
  %.307 = getelementptr i8, ptr %arg.leg.4, i64 %.305
  %.309 = load double, ptr %.307, align 8
  %.337 = mul i64 %arg.leg.6.0, 14
  %.339 = getelementptr i8, ptr %arg.leg.4, i64 %.337
  %.341 = load double, ptr %.339, align 8
  %.369 = mul i64 %arg.leg.6.0, 15
  %.371 = getelementptr i8, ptr %arg.leg.4, i64 %.369
  %.373 = load double, ptr %.371, align 8
  %.430 = mul i64 %arg.row.6.0, 3
  %.432 = getelementptr i8, ptr %arg.row.4, i64 %.430
  %.434 = load double, ptr %.432, align 8
  %.461 = shl i64 %arg.row.6.0, 2
  %.463 = getelementptr i8, ptr %arg.row.4, i64 %.461
  %.465 = load double, ptr %.463, align 8
  %.492 = mul i64 %arg.row.6.0, 5
  %.494 = getelementptr i8, ptr %arg.row.4, i64 %.492
  %.496 = load double, ptr %.494, align 8
  %.523 = mul i64 %arg.row.6.0, 6
  %.525 = getelementptr i8, ptr %arg.row.4, i64 %.523
  %.527 = load double, ptr %.525, align 8
  %.557 = fmul double %.278, %.434
  %0 = fmul double %.309, %.465
  %.559 = fadd double %.557, %0
  %1 = fmul double %.341, %.496
  %.561 = fadd double %.559, %1
  %2 = fmul double %.373, %.527
  %.563 = fadd double %.561, %2
  %.564 = fmul double %.278, %.465
  %3 = fmul double %.309, %.434
  %.566 = fsub double %.564, %3
  %4 = fmul double %.341, %.527
  %.568 = fsub double %.566, %4
  %5 = fmul double %.373, %.496
  %.570 = fadd double %5, %.568
  %.571 = fmul double %.278, %.496
  %6 = fmul double %.341, %.434
  %.573 = fsub double %.571, %6
  %7 = fmul double %.373, %.465
  %.575 = fsub double %.573, %7
  %8 = fmul double %.309, %.527
  %.577 = fadd double %8, %.575
  %.578 = fmul double %.278, %.527
  %9 = fmul double %.373, %.434
  %.580 = fsub double %.578, %9
  %10 = fmul double %.309, %.496
  %.582 = fsub double %.580, %10
  %11 = fmul double %.341, %.465
  %.584 = fadd double %11, %.582
  %.623 = fcmp olt double %.563, 0.000000e+00
  %"$phi470.0.2.0" = select i1 %.623, double -1.000000e+00, double 1.000000e+00
  %.640 = fmul double %.570, %.570
  %.643 = fmul double %.577, %.577
  %.644 = fadd double %.640, %.643
  %.647 = fmul double %.584, %.584
  %.648 = fadd double %.644, %.647
  %sqrt = tail call double @llvm.sqrt.f64(double %.648)
  %.654 = fcmp ogt double %sqrt, 0x16687E92154EF7AC
  %.658 = fmul double %"$phi470.0.2.0", 2.000000e+00
  br i1 %.654, label %B544, label %B608

B544:                                             ; preds = %B116
  %.661 = fmul double %.563, %"$phi470.0.2.0"
  %.667 = tail call double @atan2(double %sqrt, double %.661)
  %.668 = fmul double %.658, %.667
  %.673 = fdiv double %.668, %sqrt
  br label %B608

B608:                                             ; preds = %B544, %B116
  %"$phi608.0.2.0" = phi double [ %.673, %B544 ], [ %.658, %B116 ]
  %.695 = fmul double %.570, %"$phi608.0.2.0"
  %.699 = fmul double %.577, %"$phi608.0.2.0"
  %.703 = fmul double %.584, %"$phi608.0.2.0"
  br label %common.ret
}

; Function Attrs: mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite)
define internal fastcc void @part.1(ptr noalias nonnull writeonly captures(none) initializes((0, 24)) %retptr, ptr readonly captures(none) %arg.leg.4, i64 %arg.leg.6.0, ptr readonly captures(none) %arg.row.4, i64 %arg.row.6.0, double %arg.turn.0, double %arg.turn.1, double %arg.turn.2, double %arg.tolerance) unnamed_addr #2 {
B0:
  %.71 = load double, ptr %arg.leg.4, align 8
  %.101 = load double, ptr %arg.row.4, align 8
  %.102 = fsub double %.71, %.101
  %.131 = getelementptr i8, ptr %arg.leg.4, i64 %arg.leg.6.0
  %.133 = load double, ptr %.131, align 8
  %.161 = getelementptr i8, ptr %arg.row.4, i64 %arg.row.6.0
  %.163 = load double, ptr %.161, align 8
  %.164 = fsub double %.133, %.163
  %.191 = shl i64 %arg.leg.6.0, 1
  %.193 = getelementptr i8, ptr %arg.leg.4, i64 %.191
  %.195 = load double, ptr %.193, align 8
  %.221 = shl i64 %arg.row.6.0, 1
  %.223 = getelementptr i8, ptr %arg.row.4, i64 %.221
  %.225 = load double, ptr %.223, align 8
  %.229 = fsub double %.195, %.225
  %.256 = mul i64 %arg.leg.6.0, 3
  %.258 = getelementptr i8, ptr %arg.leg.4, i64 %.256
  %.260 = load double, ptr %.258, align 8
  %.287 = shl i64 %arg.leg.6.0, 2
  %.289 = getelementptr i8, ptr %arg.leg.4, i64 %.287
  %.291 = load double, ptr %.289, align 8
  %.318 = mul i64 %arg.leg.6.0, 5
  %.320 = getelementptr i8, ptr %arg.leg.4, i64 %.318
  %.322 = load double, ptr %.320, align 8
  %.13.i = fmul double %.260, %.260
  %.14.i = fmul double %.291, %.291
  %.15.i = fadd double %.13.i, %.14.i
  %.16.i = fmul double %.322, %.322
  %.17.i = fadd double %.15.i, %.16.i
  %.23.i = fmul double %.102, %.102
  %.24.i = fmul double %.164, %.164
  %.25.i = fadd double %.23.i, %.24.i
  %.26.i = fmul double %.229, %.229
  %.27.i = fadd double %.25.i, %.26.i
  %.39.i = fcmp oeq double %.17.i, 0.000000e+00
  br i1 %.39.i, label %B118.i, label %B200.endif.endif.endif.i

B118.i:                                           ; preds = %B0
  %.47.i = fmul double %arg.tolerance, %arg.tolerance
  %.51.i = fcmp ole double %.27.i, %.47.i
  %"$phi198.0.2.sroa.8.0.i" = select i1 %.51.i, double 0x7FF0000000000000, double 0xFFF0000000000000
  %"$phi198.0.2.sroa.0.0.i" = select i1 %.51.i, double 0xFFF0000000000000, double 0x7FF0000000000000
  br label %B0.endif

B200.endif.endif.endif.i:                         ; preds = %B0
  %.18.i = fmul double %.102, %.260
  %.19.i = fmul double %.164, %.291
  %.20.i = fadd double %.18.i, %.19.i
  %.21.i = fmul double %.229, %.322
  %.22.i = fadd double %.20.i, %.21.i
  %.118.i = fneg double %.22.i
  %.123.i = fdiv double %.118.i, %.17.i
  %.134.i = fmul double %.22.i, %.22.i
  %.141.i = fdiv double %.134.i, %.17.i
  %.143.i = fsub double %.27.i, %.141.i
  %.12.i.i = fcmp ogt double %.143.i, 0.000000e+00
  %.13.i.i = select i1 %.12.i.i, double %.143.i, double 0.000000e+00
  %.129.i = fmul double %arg.tolerance, %arg.tolerance
  %.176.i = fsub double %.129.i, %.13.i.i
  %.182.i = fcmp olt double %.176.i, 0.000000e+00
  br i1 %.182.i, label %B0.endif, label %B318.endif.i

B318.endif.i:                                     ; preds = %B200.endif.endif.endif.i
  %.211.i = fdiv double %.176.i, %.17.i
  %.216.i = tail call double @sqrt(double %.211.i)
  %.218.i = fsub double %.123.i, %.216.i
  %.220.i = fadd double %.123.i, %.216.i
  br label %B0.endif

common.ret:                                       ; preds = %B332.endif, %B0.endif.endif
  %a.2.0 = phi double [ %.218.sink.i, %B0.endif.endif ], [ %.13.i1, %B332.endif ]
  %b.2.0 = phi double [ %.220.sink.i, %B0.endif.endif ], [ %.13.i46, %B332.endif ]
  %.668 = mul i64 %arg.leg.6.0, 9
  %.670 = getelementptr i8, ptr %arg.leg.4, i64 %.668
  %.672 = load double, ptr %.670, align 8
  %.678 = fcmp une double %.672, 0.000000e+00
  %"$phi422.2.2.0" = select i1 %.678, double %.123.sink.i, double %.123.sink.i36
  store double %a.2.0, ptr %retptr, align 8
  %retptr.repack246 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store double %b.2.0, ptr %retptr.repack246, align 8
  %retptr.repack248 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store double %"$phi422.2.2.0", ptr %retptr.repack248, align 8
  ret void

B0.endif:                                         ; preds = %B318.endif.i, %B200.endif.endif.endif.i, %B118.i
  %.218.sink.i = phi double [ %.218.i, %B318.endif.i ], [ %"$phi198.0.2.sroa.0.0.i", %B118.i ], [ 0x7FF0000000000000, %B200.endif.endif.endif.i ]
  %.220.sink.i = phi double [ %.220.i, %B318.endif.i ], [ %"$phi198.0.2.sroa.8.0.i", %B118.i ], [ 0xFFF0000000000000, %B200.endif.endif.endif.i ]
  %.123.sink.i = phi double [ %.123.i, %B318.endif.i ], [ 0.000000e+00, %B118.i ], [ %.123.i, %B200.endif.endif.endif.i ]
  %.414 = mul i64 %arg.leg.6.0, 6
  %.416 = getelementptr i8, ptr %arg.leg.4, i64 %.414
  %.418 = load double, ptr %.416, align 8
  %.445 = mul i64 %arg.leg.6.0, 7
  %.447 = getelementptr i8, ptr %arg.leg.4, i64 %.445
  %.449 = load double, ptr %.447, align 8
  %.476 = shl i64 %arg.leg.6.0, 3
  %.478 = getelementptr i8, ptr %arg.leg.4, i64 %.476
  %.480 = load double, ptr %.478, align 8
  %.507 = mul i64 %arg.leg.6.0, 11
  %.509 = getelementptr i8, ptr %arg.leg.4, i64 %.507
  %.511 = load double, ptr %.509, align 8
  %.13.i2 = fmul double %.418, %.418
  %.14.i3 = fmul double %.449, %.449
  %.15.i4 = fadd double %.13.i2, %.14.i3
  %.16.i5 = fmul double %.480, %.480
  %.17.i6 = fadd double %.15.i4, %.16.i5
  %.23.i7 = fmul double %arg.turn.0, %arg.turn.0
  %.24.i8 = fmul double %arg.turn.1, %arg.turn.1
  %.25.i9 = fadd double %.23.i7, %.24.i8
  %.26.i10 = fmul double %arg.turn.2, %arg.turn.2
  %.27.i11 = fadd double %.25.i9, %.26.i10
  %.39.i12 = fcmp oeq double %.17.i6, 0.000000e+00
  br i1 %.39.i12, label %B118.i39, label %B200.endif.endif.endif.i13

B118.i39:                                         ; preds = %B0.endif
  %.47.i40 = fmul double %.511, %.511
  %.51.i41 = fcmp ole double %.27.i11, %.47.i40
  %"$phi198.0.2.sroa.8.0.i42" = select i1 %.51.i41, double 0x7FF0000000000000, double 0xFFF0000000000000
  %"$phi198.0.2.sroa.0.0.i43" = select i1 %.51.i41, double 0xFFF0000000000000, double 0x7FF0000000000000
  br label %B0.endif.endif

B200.endif.endif.endif.i13:                       ; preds = %B0.endif
  %.382 = fneg double %arg.turn.1
  %.19.i15 = fmul double %.449, %.382
  %0 = fmul double %arg.turn.0, %.418
  %.20.i16 = fsub double %.19.i15, %0
  %1 = fmul double %arg.turn.2, %.480
  %.22.i18 = fsub double %.20.i16, %1
  %.118.i19 = fneg double %.22.i18
  %.123.i20 = fdiv double %.118.i19, %.17.i6
  %.134.i21 = fmul double %.22.i18, %.22.i18
  %.141.i22 = fdiv double %.134.i21, %.17.i6
  %.143.i23 = fsub double %.27.i11, %.141.i22
  %.12.i.i24 = fcmp ogt double %.143.i23, 0.000000e+00
  %.13.i.i25 = select i1 %.12.i.i24, double %.143.i23, double 0.000000e+00
  %.129.i26 = fmul double %.511, %.511
  %.176.i27 = fsub double %.129.i26, %.13.i.i25
  %.182.i28 = fcmp olt double %.176.i27, 0.000000e+00
  br i1 %.182.i28, label %B0.endif.endif, label %B318.endif.i29

B318.endif.i29:                                   ; preds = %B200.endif.endif.endif.i13
  %.211.i30 = fdiv double %.176.i27, %.17.i6
  %.216.i31 = tail call double @sqrt(double %.211.i30)
  %.218.i32 = fsub double %.123.i20, %.216.i31
  %.220.i33 = fadd double %.123.i20, %.216.i31
  br label %B0.endif.endif

B0.endif.endif:                                   ; preds = %B318.endif.i29, %B200.endif.endif.endif.i13, %B118.i39
  %.218.sink.i34 = phi double [ %.218.i32, %B318.endif.i29 ], [ %"$phi198.0.2.sroa.0.0.i43", %B118.i39 ], [ 0x7FF0000000000000, %B200.endif.endif.endif.i13 ]
  %.220.sink.i35 = phi double [ %.220.i33, %B318.endif.i29 ], [ %"$phi198.0.2.sroa.8.0.i42", %B118.i39 ], [ 0xFFF0000000000000, %B200.endif.endif.endif.i13 ]
  %.123.sink.i36 = phi double [ %.123.i20, %B318.endif.i29 ], [ 0.000000e+00, %B118.i39 ], [ %.123.i20, %B200.endif.endif.endif.i13 ]
  %.559 = fcmp ugt double %.218.sink.i, %.220.sink.i
  br i1 %.559, label %common.ret, label %B332.endif

B332.endif:                                       ; preds = %B0.endif.endif
  %.12.i = fcmp ogt double %.218.sink.i34, %.218.sink.i
  %.13.i1 = select i1 %.12.i, double %.218.sink.i34, double %.218.sink.i
  %.12.i45 = fcmp olt double %.220.sink.i35, %.220.sink.i
  %.13.i46 = select i1 %.12.i45, double %.220.sink.i35, double %.220.sink.i
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sqrt.f64(double) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare { i64, i1 } @llvm.usub.with.overflow.i64(i64, i64) #1

; Function Attrs: mustprogress nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #3

; Function Attrs: mustprogress nofree nosync nounwind willreturn memory(none)
declare double @atan2(double, double) local_unnamed_addr #3

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #1 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #2 = { mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite) }
attributes #3 = { mustprogress nofree nosync nounwind willreturn memory(none) }

!0 = distinct !{!0, !1}
!1 = !{!"llvm.loop.peeled.count", i32 1}
!2 = distinct !{!2, !1}
