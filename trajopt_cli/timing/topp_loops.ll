; sha256 915ae7be3355bc4d41607395a738dc2ddb9dad36de7753dff3efe15c66ddacf7 of topp_loops.py and of this
; made by numba 0.68.1, llvmlite 0.50.0, Python 3.11.7
; loops.fill_rates: array(float64, 2d, A); array(float64, 2d, A); array(float64, 3d, A); array(float64, 3d, A); array(float64, 3d, A); array(float64, 3d, A); array(float64, 3d, A); array(float64, 3d, A); array(float64, 1d, A); array(float64, 1d, A); array(float64, 2d, C); array(float64, 2d, C); array(float64, 2d, C)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.fill_rates(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.s.0, ptr readnone captures(none) %arg.s.1, i64 %arg.s.2, i64 %arg.s.3, ptr readonly captures(none) %arg.s.4, i64 %arg.s.5.0, i64 %arg.s.5.1, i64 %arg.s.6.0, i64 %arg.s.6.1, ptr readnone captures(none) %arg.top.0, ptr readnone captures(none) %arg.top.1, i64 %arg.top.2, i64 %arg.top.3, ptr readonly captures(none) %arg.top.4, i64 %arg.top.5.0, i64 %arg.top.5.1, i64 %arg.top.6.0, i64 %arg.top.6.1, ptr readnone captures(none) %arg.slopes_0.0, ptr readnone captures(none) %arg.slopes_0.1, i64 %arg.slopes_0.2, i64 %arg.slopes_0.3, ptr readonly captures(none) %arg.slopes_0.4, i64 %arg.slopes_0.5.0, i64 %arg.slopes_0.5.1, i64 %arg.slopes_0.5.2, i64 %arg.slopes_0.6.0, i64 %arg.slopes_0.6.1, i64 %arg.slopes_0.6.2, ptr readnone captures(none) %arg.bends_0.0, ptr readnone captures(none) %arg.bends_0.1, i64 %arg.bends_0.2, i64 %arg.bends_0.3, ptr readonly captures(none) %arg.bends_0.4, i64 %arg.bends_0.5.0, i64 %arg.bends_0.5.1, i64 %arg.bends_0.5.2, i64 %arg.bends_0.6.0, i64 %arg.bends_0.6.1, i64 %arg.bends_0.6.2, ptr readnone captures(none) %arg.rests_0.0, ptr readnone captures(none) %arg.rests_0.1, i64 %arg.rests_0.2, i64 %arg.rests_0.3, ptr readonly captures(none) %arg.rests_0.4, i64 %arg.rests_0.5.0, i64 %arg.rests_0.5.1, i64 %arg.rests_0.5.2, i64 %arg.rests_0.6.0, i64 %arg.rests_0.6.1, i64 %arg.rests_0.6.2, ptr readnone captures(none) %arg.slopes_1.0, ptr readnone captures(none) %arg.slopes_1.1, i64 %arg.slopes_1.2, i64 %arg.slopes_1.3, ptr readonly captures(none) %arg.slopes_1.4, i64 %arg.slopes_1.5.0, i64 %arg.slopes_1.5.1, i64 %arg.slopes_1.5.2, i64 %arg.slopes_1.6.0, i64 %arg.slopes_1.6.1, i64 %arg.slopes_1.6.2, ptr readnone captures(none) %arg.bends_1.0, ptr readnone captures(none) %arg.bends_1.1, i64 %arg.bends_1.2, i64 %arg.bends_1.3, ptr readonly captures(none) %arg.bends_1.4, i64 %arg.bends_1.5.0, i64 %arg.bends_1.5.1, i64 %arg.bends_1.5.2, i64 %arg.bends_1.6.0, i64 %arg.bends_1.6.1, i64 %arg.bends_1.6.2, ptr readnone captures(none) %arg.rests_1.0, ptr readnone captures(none) %arg.rests_1.1, i64 %arg.rests_1.2, i64 %arg.rests_1.3, ptr readonly captures(none) %arg.rests_1.4, i64 %arg.rests_1.5.0, i64 %arg.rests_1.5.1, i64 %arg.rests_1.5.2, i64 %arg.rests_1.6.0, i64 %arg.rests_1.6.1, i64 %arg.rests_1.6.2, ptr readnone captures(none) %arg.x_0.0, ptr readnone captures(none) %arg.x_0.1, i64 %arg.x_0.2, i64 %arg.x_0.3, ptr readonly captures(none) %arg.x_0.4, i64 %arg.x_0.5.0, i64 %arg.x_0.6.0, ptr readnone captures(none) %arg.x_1.0, ptr readnone captures(none) %arg.x_1.1, i64 %arg.x_1.2, i64 %arg.x_1.3, ptr readonly captures(none) %arg.x_1.4, i64 %arg.x_1.5.0, i64 %arg.x_1.6.0, ptr readnone captures(none) %arg.of_rows.0, ptr readnone captures(none) %arg.of_rows.1, i64 %arg.of_rows.2, i64 %arg.of_rows.3, ptr captures(none) %arg.of_rows.4, i64 %arg.of_rows.5.0, i64 %arg.of_rows.5.1, i64 %arg.of_rows.6.0, i64 %arg.of_rows.6.1, ptr readnone captures(none) %arg.of_points.0, ptr readnone captures(none) %arg.of_points.1, i64 %arg.of_points.2, i64 %arg.of_points.3, ptr captures(none) %arg.of_points.4, i64 %arg.of_points.5.0, i64 %arg.of_points.5.1, i64 %arg.of_points.6.0, i64 %arg.of_points.6.1, ptr readnone captures(none) %arg.rates.0, ptr readnone captures(none) %arg.rates.1, i64 %arg.rates.2, i64 %arg.rates.3, ptr writeonly captures(none) %arg.rates.4, i64 %arg.rates.5.0, i64 %arg.rates.5.1, i64 %arg.rates.6.0, i64 %arg.rates.6.1) local_unnamed_addr #0 {
B0.endif:
  %.2561 = alloca ptr, align 8
  store ptr null, ptr %.2561, align 8
  %.5478 = alloca ptr, align 8
  store ptr null, ptr %.5478, align 8
  %.380 = getelementptr double, ptr %arg.of_rows.4, i64 %arg.of_rows.5.1
  %.450.idx = shl i64 %arg.of_rows.5.1, 4
  %.450 = getelementptr i8, ptr %arg.of_rows.4, i64 %.450.idx
  %.520.idx = mul i64 %arg.of_rows.5.1, 24
  %.520 = getelementptr i8, ptr %arg.of_rows.4, i64 %.520.idx
  %.590.idx = shl i64 %arg.of_rows.5.1, 5
  %.590 = getelementptr i8, ptr %arg.of_rows.4, i64 %.590.idx
  %.660.idx = mul i64 %arg.of_rows.5.1, 40
  %.660 = getelementptr i8, ptr %arg.of_rows.4, i64 %.660.idx
  %.1021 = getelementptr double, ptr %arg.of_points.4, i64 %arg.of_points.5.1
  %.1091.idx = shl i64 %arg.of_points.5.1, 4
  %.1091 = getelementptr i8, ptr %arg.of_points.4, i64 %.1091.idx
  %.1161.idx = mul i64 %arg.of_points.5.1, 24
  %.1161 = getelementptr i8, ptr %arg.of_points.4, i64 %.1161.idx
  %.1231.idx = shl i64 %arg.of_points.5.1, 5
  %.1231 = getelementptr i8, ptr %arg.of_points.4, i64 %.1231.idx
  %.17543143.not = icmp slt i64 %arg.top.5.0, 1
  br i1 %.17543143.not, label %B3566, label %B302.endif.lr.ph

B302.endif.lr.ph:                                 ; preds = %B0.endif
  %.2430 = add nsw i64 %arg.of_points.5.1, -2
  %0 = tail call i64 @llvm.smax.i64(i64 %arg.of_points.5.1, i64 1)
  %storemerge2373 = add nsw i64 %0, -1
  %unroll_iter.i = and i64 %arg.of_rows.5.1, 9223372036854775806
  %1 = shl i64 %arg.of_points.5.1, 3
  %scevgep370 = getelementptr i8, ptr %arg.of_points.4, i64 %1
  %2 = add nsw i64 %arg.top.5.0, -1
  %3 = mul i64 %arg.top.6.0, %2
  %4 = getelementptr i8, ptr %arg.top.4, i64 %arg.of_points.5.1
  %5 = getelementptr i8, ptr %4, i64 %3
  %scevgep371 = getelementptr i8, ptr %5, i64 7
  %bound0 = icmp ult ptr %arg.of_points.4, %scevgep371
  %bound1 = icmp ult ptr %arg.top.4, %scevgep370
  %found.conflict = and i1 %bound1, %bound0
  %stride.check = icmp slt i64 %arg.top.6.0, 0
  %6 = or i1 %stride.check, %found.conflict
  %n.vec = and i64 %arg.of_points.5.1, 9223372036854775804
  %scevgep381 = getelementptr i8, ptr %arg.top.4, i64 3
  %7 = shl i64 %arg.top.6.1, 1
  %scevgep421 = getelementptr i8, ptr %.660, i64 8
  %scevgep425 = getelementptr i8, ptr %.520, i64 8
  %8 = icmp slt i64 %arg.of_points.5.1, 1
  %9 = icmp sgt i64 %arg.of_points.5.1, 1
  %sunkaddr455 = getelementptr i8, ptr %scevgep370, i64 -8
  %sunkaddr457 = getelementptr i8, ptr %.1231, i64 %1
  %sunkaddr458 = getelementptr i8, ptr %sunkaddr457, i64 -8
  %sunkaddr460 = getelementptr i8, ptr %.1161, i64 %1
  %sunkaddr461 = getelementptr i8, ptr %sunkaddr460, i64 -8
  %10 = icmp ne i64 %arg.top.6.1, 1
  %11 = icmp samesign ult i64 %arg.of_points.5.1, 6
  %12 = icmp eq i64 %arg.of_points.5.1, %n.vec
  %13 = and i64 %arg.of_points.5.1, 1
  %14 = icmp eq i64 %13, 0
  %15 = icmp slt i64 %arg.of_rows.5.1, 1
  %sunkaddr462 = shl i64 %arg.of_rows.5.1, 3
  %16 = tail call i64 @llvm.smax.i64(i64 %arg.of_rows.5.1, i64 0)
  %storemerge.i = shl nuw i64 %16, 1
  %.142255.i = icmp sgt i64 %storemerge.i, 0
  %17 = icmp eq i64 %arg.of_rows.5.1, 1
  %18 = and i64 %arg.of_rows.5.1, 1
  %19 = icmp eq i64 %18, 0
  %sunkaddr31.i = shl i64 %unroll_iter.i, 3
  %sunkaddr32.i = getelementptr i8, ptr %.520, i64 %sunkaddr31.i
  %sunkaddr34.i = getelementptr i8, ptr %.660, i64 %sunkaddr31.i
  %sunkaddr46.i = getelementptr i8, ptr %.590, i64 %sunkaddr31.i
  %20 = getelementptr double, ptr %.520, i64 %unroll_iter.i
  %21 = getelementptr double, ptr %.660, i64 %unroll_iter.i
  br label %B302.endif

B300.loopexit:                                    ; preds = %B3540, %B2828.endif
  %scevgep382 = getelementptr i8, ptr %lsr.iv, i64 %arg.top.6.0
  %scevgep395 = getelementptr i8, ptr %lsr.iv394, i64 %arg.top.6.0
  %exitcond3883.not = icmp eq i64 %.1767, %arg.top.5.0
  br i1 %exitcond3883.not, label %B3566, label %B302.endif

B704:                                             ; preds = %B526.endif, %B2392.endif
  %failed.5.12728 = phi i1 [ %failed.6.2, %B2392.endif ], [ %"$phi526.1.2.1", %B526.endif ]
  %.251026362727 = phi i64 [ %.2520, %B2392.endif ], [ %storemerge2373, %B526.endif ]
  %.251726592726 = phi i64 [ %.2524, %B2392.endif ], [ %.2430, %B526.endif ]
  %.2520 = add nsw i64 %.251026362727, -1
  %.2524 = add i64 %.251726592726, -1
  call fastcc void @part.0(ptr nonnull %.2561, ptr %arg.of_rows.4, i64 %arg.of_rows.5.1, ptr %.380, ptr %.450, ptr %arg.s.4, i64 %arg.s.5.0, i64 %arg.s.5.1, i64 %arg.s.6.0, i64 %arg.s.6.1, ptr %arg.slopes_0.4, i64 %arg.slopes_0.5.0, i64 %arg.slopes_0.5.1, i64 %arg.slopes_0.6.0, i64 %arg.slopes_0.6.1, i64 %arg.slopes_0.6.2, ptr %arg.bends_0.4, i64 %arg.bends_0.5.0, i64 %arg.bends_0.5.1, i64 %arg.bends_0.6.0, i64 %arg.bends_0.6.1, i64 %arg.bends_0.6.2, ptr %arg.rests_0.4, i64 %arg.rests_0.5.0, i64 %arg.rests_0.5.1, i64 %arg.rests_0.6.0, i64 %arg.rests_0.6.1, i64 %arg.rests_0.6.2, ptr %arg.slopes_1.4, i64 %arg.slopes_1.5.0, i64 %arg.slopes_1.5.1, i64 %arg.slopes_1.6.0, i64 %arg.slopes_1.6.1, i64 %arg.slopes_1.6.2, ptr %arg.bends_1.4, i64 %arg.bends_1.5.0, i64 %arg.bends_1.5.1, i64 %arg.bends_1.6.0, i64 %arg.bends_1.6.1, i64 %arg.bends_1.6.2, ptr %arg.rests_1.4, i64 %arg.rests_1.5.0, i64 %arg.rests_1.5.1, i64 %arg.rests_1.6.0, i64 %arg.rests_1.6.1, i64 %arg.rests_1.6.2, i64 %.176028013152, i64 %.251726592726)
  br i1 %15, label %B704.endif.endif, label %B62.i

B1008:                                            ; preds = %B1008.preheader, %B3567
  %lsr.iv419 = phi i64 [ %lsr.iv.next420, %B3567 ], [ %arg.of_rows.5.1, %B1008.preheader ]
  %lsr.iv412 = phi ptr [ %scevgep413, %B3567 ], [ %arg.of_rows.4, %B1008.preheader ]
  %sunkaddr438 = getelementptr i8, ptr %lsr.iv412, i64 %sunkaddr462
  %.3079 = load double, ptr %sunkaddr438, align 8
  %.3080 = tail call double @llvm.fabs.f64(double %.3079)
  %.3082 = fmul double %.13.i254, %.3080
  %.3113 = load double, ptr %lsr.iv412, align 8
  %.3114 = tail call double @llvm.fabs.f64(double %.3113)
  %.3116 = fmul double %y.2.0245.i, %.3114
  %.3124 = fcmp olt double %.3082, 1.000000e-09
  %.3127 = fcmp olt double %.3116, 1.000000e-09
  %or.cond = select i1 %.3124, i1 true, i1 %.3127
  br i1 %or.cond, label %B1150, label %B3567

B1150:                                            ; preds = %B1008
  %scevgep417 = getelementptr i8, ptr %lsr.iv412, i64 %.520.idx
  store double 0x7FF0000000000000, ptr %scevgep417, align 8
  %scevgep416 = getelementptr i8, ptr %lsr.iv412, i64 %.660.idx
  store double 0.000000e+00, ptr %scevgep416, align 8
  %.3192 = fcmp ult double %.3082, 1.000000e-09
  br i1 %.3192, label %B1396, label %B1214.endif.endif.endif.endif

B1396:                                            ; preds = %B1150
  %.3445 = fcmp ult double %.3116, 1.000000e-09
  br i1 %.3445, label %B3567, label %B1418.endif.endif.endif.endif

B2446:                                            ; preds = %B2392.endif, %B526.endif
  %failed.5.1.lcssa = phi i1 [ %"$phi526.1.2.1", %B526.endif ], [ %failed.6.2, %B2392.endif ]
  %.4895 = load double, ptr %.1161, align 8
  %.4925 = load double, ptr %.1231, align 8
  %.4928 = fmul double %.4925, 0x3FF000000044B830
  %.4961 = mul i64 %.176028013152, %arg.x_0.6.0
  %.4963 = getelementptr i8, ptr %arg.x_0.4, i64 %.4961
  %.4965 = load double, ptr %.4963, align 8
  %.4999 = fcmp ogt double %.4965, %.4928
  %.5036 = fcmp one double %.4965, 0x7FF0000000000000
  %or.cond2371 = and i1 %.4999, %.5036
  br i1 %or.cond2371, label %B2670.endif.endif.thread, label %B2670.endif.endif

B2670.endif.endif.thread:                         ; preds = %B2446
  %.12.i244339 = fcmp ogt double %.4895, %.4965
  %.13.i245340 = select i1 %.12.i244339, double %.4895, double %.4965
  %.12.i319341 = fcmp olt double %.4925, %.13.i245340
  %.13.i320342 = select i1 %.12.i319341, double %.4925, double %.13.i245340
  br label %B2828.endif

B2800:                                            ; preds = %B2670.endif.endif
  %.5278 = tail call double @sqrt(double %.13.i320)
  br label %B2828.endif

B2880:                                            ; preds = %B2828.endif, %B3540
  %x.4.12765 = phi double [ %.13.i252, %B3540 ], [ %.13.i320344, %B2828.endif ]
  %.543427492763 = phi i64 [ %.5441, %B3540 ], [ 0, %B2828.endif ]
  %.5441 = add nuw nsw i64 %.543427492763, 1
  call fastcc void @part.0(ptr nonnull %.5478, ptr %arg.of_rows.4, i64 %arg.of_rows.5.1, ptr %.380, ptr %.450, ptr %arg.s.4, i64 %arg.s.5.0, i64 %arg.s.5.1, i64 %arg.s.6.0, i64 %arg.s.6.1, ptr %arg.slopes_0.4, i64 %arg.slopes_0.5.0, i64 %arg.slopes_0.5.1, i64 %arg.slopes_0.6.0, i64 %arg.slopes_0.6.1, i64 %arg.slopes_0.6.2, ptr %arg.bends_0.4, i64 %arg.bends_0.5.0, i64 %arg.bends_0.5.1, i64 %arg.bends_0.6.0, i64 %arg.bends_0.6.1, i64 %arg.bends_0.6.2, ptr %arg.rests_0.4, i64 %arg.rests_0.5.0, i64 %arg.rests_0.5.1, i64 %arg.rests_0.6.0, i64 %arg.rests_0.6.1, i64 %arg.rests_0.6.2, ptr %arg.slopes_1.4, i64 %arg.slopes_1.5.0, i64 %arg.slopes_1.5.1, i64 %arg.slopes_1.6.0, i64 %arg.slopes_1.6.1, i64 %arg.slopes_1.6.2, ptr %arg.bends_1.4, i64 %arg.bends_1.5.0, i64 %arg.bends_1.5.1, i64 %arg.bends_1.6.0, i64 %arg.bends_1.6.1, i64 %arg.bends_1.6.2, ptr %arg.rests_1.4, i64 %arg.rests_1.5.0, i64 %arg.rests_1.5.1, i64 %arg.rests_1.6.0, i64 %arg.rests_1.6.1, i64 %arg.rests_1.6.2, i64 %.176028013152, i64 %.543427492763)
  %.5584 = getelementptr double, ptr %.1231, i64 %.5441
  %.5585 = load double, ptr %.5584, align 8
  br i1 %15, label %B3434.endif, label %B3006.preheader

B3006.preheader:                                  ; preds = %B2880
  %sunkaddr439 = shl i64 %.543427492763, 3
  %sunkaddr440 = getelementptr i8, ptr %.1091, i64 %sunkaddr439
  %sunkaddr442 = getelementptr i8, ptr %.1021, i64 %sunkaddr439
  br label %B3006

B3006:                                            ; preds = %B3006.preheader, %B3432
  %y.5.22741 = phi double [ %y.6.3, %B3432 ], [ %.5585, %B3006.preheader ]
  %.568427362739 = phi i64 [ %.5691, %B3432 ], [ 0, %B3006.preheader ]
  %.5691 = add nuw nsw i64 %.568427362739, 1
  %22 = shl i64 %.568427362739, 3
  %scevgep437 = getelementptr i8, ptr %arg.of_rows.4, i64 %22
  %.5753 = load double, ptr %scevgep437, align 8
  %.5754 = tail call double @llvm.fabs.f64(double %.5753)
  %scevgep436 = getelementptr i8, ptr %.380, i64 %22
  %.5817 = load double, ptr %scevgep436, align 8
  %.5818 = tail call double @llvm.fabs.f64(double %.5817)
  %.5819 = fmul double %.5818, 0x3D06849B86A12B9B
  %.5820 = fcmp ogt double %.5754, %.5819
  br i1 %.5820, label %B3158, label %B3432

B3158:                                            ; preds = %B3006
  %.5858 = load double, ptr %sunkaddr440, align 8
  %.5860 = fmul double %.5754, %.5858
  %.5861 = fcmp ult double %.5860, 1.000000e-09
  br i1 %.5861, label %B3432, label %B3198

B3198:                                            ; preds = %B3158
  %.5928 = load double, ptr %sunkaddr442, align 8
  %.5929 = fmul double %.5818, %.5928
  %.5930 = fcmp ult double %.5929, 1.000000e-09
  br i1 %.5930, label %B3432, label %B3276.endif

B3432:                                            ; preds = %B3276.endif, %B3198, %B3158, %B3006
  %y.6.3 = phi double [ %y.5.22741, %B3006 ], [ %y.5.22741, %B3198 ], [ %y.5.22741, %B3158 ], [ %.13.i322, %B3276.endif ]
  %exitcond3881.not = icmp eq i64 %arg.of_rows.5.1, %.5691
  br i1 %exitcond3881.not, label %B3434.endif, label %B3006

B3512:                                            ; preds = %B3434.endif
  %.6282 = tail call double @sqrt(double %.13.i252)
  br label %B3540

B3540:                                            ; preds = %B3434.endif, %B3512
  %"$phi3540.2.2.2" = phi double [ %.6282, %B3512 ], [ 0x7FF8000000000000, %B3434.endif ]
  %23 = getelementptr double, ptr %.5342, i64 %.5441
  store double %"$phi3540.2.2.2", ptr %23, align 8
  %exitcond3882.not = icmp eq i64 %.5441, %storemerge2373
  br i1 %exitcond3882.not, label %B300.loopexit, label %B2880

B3566:                                            ; preds = %B300.loopexit, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B3567:                                            ; preds = %B1418.endif.endif.endif.endif, %B1214.endif.endif.endif.endif, %B1396, %B1008
  %scevgep413 = getelementptr i8, ptr %lsr.iv412, i64 8
  %lsr.iv.next420 = add nsw i64 %lsr.iv419, -1
  %exitcond3880.not = icmp eq i64 %lsr.iv.next420, 0
  br i1 %exitcond3880.not, label %B1614.endif.endif.endif.endif, label %B1008

B302.endif:                                       ; preds = %B300.loopexit, %B302.endif.lr.ph
  %lsr.iv394 = phi ptr [ %arg.top.4, %B302.endif.lr.ph ], [ %scevgep395, %B300.loopexit ]
  %lsr.iv = phi ptr [ %scevgep381, %B302.endif.lr.ph ], [ %scevgep382, %B300.loopexit ]
  %.176028013152 = phi i64 [ 0, %B302.endif.lr.ph ], [ %.1767, %B300.loopexit ]
  %24 = mul i64 %.176028013152, %arg.top.6.0
  %scevgep = getelementptr i8, ptr %arg.top.4, i64 %24
  %.1767 = add nuw nsw i64 %.176028013152, 1
  br i1 %8, label %B526.endif, label %B336.lr.ph

B336.lr.ph:                                       ; preds = %B302.endif
  %25 = getelementptr i8, ptr %scevgep, i64 %arg.of_points.5.1
  %26 = getelementptr i8, ptr %25, i64 -1
  %27 = icmp ult ptr %26, %scevgep
  %28 = or i1 %10, %27
  %or.cond378 = select i1 %11, i1 true, i1 %28
  %brmerge = select i1 %or.cond378, i1 true, i1 %6
  br i1 %brmerge, label %B336.endif.preheader, label %vector.body

vector.body:                                      ; preds = %B336.lr.ph, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %B336.lr.ph ]
  %scevgep388 = getelementptr i8, ptr %lsr.iv, i64 %index
  %scevgep389 = getelementptr i8, ptr %scevgep388, i64 -3
  %scevgep387 = getelementptr i8, ptr %scevgep388, i64 -2
  %scevgep385 = getelementptr i8, ptr %scevgep388, i64 -1
  %29 = load double, ptr %scevgep389, align 8, !alias.scope !0
  %30 = load double, ptr %scevgep387, align 8, !alias.scope !0
  %31 = insertelement <2 x double> poison, double %29, i64 0
  %32 = insertelement <2 x double> %31, double %30, i64 1
  %33 = load double, ptr %scevgep385, align 8, !alias.scope !0
  %34 = load double, ptr %scevgep388, align 8, !alias.scope !0
  %35 = insertelement <2 x double> poison, double %33, i64 0
  %36 = insertelement <2 x double> %35, double %34, i64 1
  %37 = fmul <2 x double> %32, %32
  %38 = fmul <2 x double> %36, %36
  %39 = fcmp ogt <2 x double> %37, splat (double 1.000000e+12)
  %40 = fcmp ogt <2 x double> %38, splat (double 1.000000e+12)
  %41 = select <2 x i1> %39, <2 x double> splat (double 1.000000e+12), <2 x double> %37
  %42 = select <2 x i1> %40, <2 x double> splat (double 1.000000e+12), <2 x double> %38
  %sunkaddr443 = shl i64 %index, 3
  %sunkaddr444 = getelementptr i8, ptr %arg.of_points.4, i64 %sunkaddr443
  store <2 x double> %41, ptr %sunkaddr444, align 8, !alias.scope !3, !noalias !0
  %sunkaddr447 = getelementptr i8, ptr %sunkaddr444, i64 16
  store <2 x double> %42, ptr %sunkaddr447, align 8, !alias.scope !3, !noalias !0
  %index.next = add nuw nsw i64 %index, 4
  %43 = icmp eq i64 %n.vec, %index.next
  br i1 %43, label %middle.block, label %vector.body, !llvm.loop !5

middle.block:                                     ; preds = %vector.body
  br i1 %12, label %B526.endif, label %B336.endif.preheader

B336.endif.preheader:                             ; preds = %middle.block, %B336.lr.ph
  %.188126142616.ph = phi i64 [ 0, %B336.lr.ph ], [ %n.vec, %middle.block ]
  %.neg = or disjoint i64 %.188126142616.ph, 1
  br i1 %14, label %B336.endif.prol.loopexit, label %B336.endif.prol

B336.endif.prol:                                  ; preds = %B336.endif.preheader
  %.1960.prol = mul i64 %.188126142616.ph, %arg.top.6.1
  %.1963.prol = getelementptr i8, ptr %scevgep, i64 %.1960.prol
  %.1965.prol = load double, ptr %.1963.prol, align 8
  %.2023.prol = fmul double %.1965.prol, %.1965.prol
  %.12.i.prol = fcmp ogt double %.2023.prol, 1.000000e+12
  %.13.i.prol = select i1 %.12.i.prol, double 1.000000e+12, double %.2023.prol
  %44 = getelementptr double, ptr %arg.of_points.4, i64 %.188126142616.ph
  store double %.13.i.prol, ptr %44, align 8
  br label %B336.endif.prol.loopexit

B336.endif.prol.loopexit:                         ; preds = %B336.endif.prol, %B336.endif.preheader
  %.188126142616.unr = phi i64 [ %.188126142616.ph, %B336.endif.preheader ], [ %.neg, %B336.endif.prol ]
  %45 = icmp eq i64 %arg.of_points.5.1, %.neg
  br i1 %45, label %B526.endif, label %B336.endif.preheader380

B336.endif.preheader380:                          ; preds = %B336.endif.prol.loopexit
  %46 = mul i64 %.188126142616.unr, %arg.top.6.1
  %47 = add nuw nsw i64 %.188126142616.unr, 1
  %48 = mul i64 %47, %arg.top.6.1
  br label %B336.endif

B336.endif:                                       ; preds = %B336.endif, %B336.endif.preheader380
  %lsr.iv396 = phi ptr [ %lsr.iv394, %B336.endif.preheader380 ], [ %scevgep397, %B336.endif ]
  %.188126142616 = phi i64 [ %.188126142616.unr, %B336.endif.preheader380 ], [ %.1888.1, %B336.endif ]
  %scevgep398 = getelementptr i8, ptr %lsr.iv396, i64 %46
  %.1965 = load double, ptr %scevgep398, align 8
  %.2023 = fmul double %.1965, %.1965
  %.12.i = fcmp ogt double %.2023, 1.000000e+12
  %.13.i = select i1 %.12.i, double 1.000000e+12, double %.2023
  %sunkaddr448 = shl i64 %.188126142616, 3
  %sunkaddr449 = getelementptr i8, ptr %arg.of_points.4, i64 %sunkaddr448
  store double %.13.i, ptr %sunkaddr449, align 8
  %scevgep403 = getelementptr i8, ptr %lsr.iv396, i64 %48
  %.1965.1 = load double, ptr %scevgep403, align 8
  %.2023.1 = fmul double %.1965.1, %.1965.1
  %.12.i.1 = fcmp ogt double %.2023.1, 1.000000e+12
  %.13.i.1 = select i1 %.12.i.1, double 1.000000e+12, double %.2023.1
  %.1888.1 = add nuw nsw i64 %.188126142616, 2
  %sunkaddr452 = getelementptr i8, ptr %sunkaddr449, i64 8
  store double %.13.i.1, ptr %sunkaddr452, align 8
  %scevgep397 = getelementptr i8, ptr %lsr.iv396, i64 %7
  %exitcond.not.1 = icmp eq i64 %arg.of_points.5.1, %.1888.1
  br i1 %exitcond.not.1, label %B526.endif, label %B336.endif, !llvm.loop !8

B526.endif:                                       ; preds = %B336.endif, %B336.endif.prol.loopexit, %middle.block, %B302.endif
  %.2114 = mul i64 %.176028013152, %arg.x_1.6.0
  %.2116 = getelementptr i8, ptr %arg.x_1.4, i64 %.2114
  %.2118 = load double, ptr %.2116, align 8
  %.2148 = load double, ptr %sunkaddr455, align 8
  %.12.i231 = fcmp olt double %.2148, %.2118
  %.13.i232 = select i1 %.12.i231, double %.2148, double %.2118
  %.2189 = fcmp one double %.2118, 0x7FF0000000000000
  %.2151 = fmul double %.2148, 0x3FF000000044B830
  %.2152 = fcmp ogt double %.2118, %.2151
  %"$phi526.1.2.1" = and i1 %.2189, %.2152
  store double %.13.i232, ptr %sunkaddr458, align 8
  %.2350 = load double, ptr %.2116, align 8
  %.2351 = fcmp one double %.2350, 0x7FF0000000000000
  %"$phi652.1.2.1" = select i1 %.2351, double %.13.i232, double 0.000000e+00
  store double %"$phi652.1.2.1", ptr %sunkaddr461, align 8
  br i1 %9, label %B704, label %B2446

B62.i:                                            ; preds = %B704, %B470.i
  %lsr.iv411 = phi i64 [ %lsr.iv.next, %B470.i ], [ %arg.of_rows.5.1, %B704 ]
  %lsr.iv404 = phi ptr [ %scevgep405, %B470.i ], [ %arg.of_rows.4, %B704 ]
  %scevgep410 = getelementptr i8, ptr %lsr.iv404, i64 %.520.idx
  store double 0x7FF0000000000000, ptr %scevgep410, align 8, !noalias !9
  %scevgep409 = getelementptr i8, ptr %lsr.iv404, i64 %.590.idx
  store double 0x7FF0000000000000, ptr %scevgep409, align 8, !noalias !9
  %scevgep408 = getelementptr i8, ptr %lsr.iv404, i64 %.660.idx
  store double 0.000000e+00, ptr %scevgep408, align 8, !noalias !9
  %sunkaddr463 = getelementptr i8, ptr %lsr.iv404, i64 %sunkaddr462
  %.343.i = load double, ptr %sunkaddr463, align 8, !noalias !9
  %.344.i = tail call double @llvm.fabs.f64(double %.343.i)
  %.375.i = load double, ptr %lsr.iv404, align 8, !noalias !9
  %.376.i = tail call double @llvm.fabs.f64(double %.375.i)
  %.377.i = fmul double %.376.i, 0x3D06849B86A12B9B
  %.378.i = fcmp ogt double %.344.i, %.377.i
  br i1 %.378.i, label %B240.endif.endif.endif.i, label %B470.i

B470.i:                                           ; preds = %B240.endif.endif.endif.i, %B62.i
  %scevgep405 = getelementptr i8, ptr %lsr.iv404, i64 8
  %lsr.iv.next = add nsw i64 %lsr.iv411, -1
  %exitcond.not.i = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not.i, label %B704.endif.endif, label %B62.i

B240.endif.endif.endif.i:                         ; preds = %B62.i
  %.416.i = fdiv double 1.000000e+00, %.344.i
  %scevgep406 = getelementptr i8, ptr %lsr.iv404, i64 %.450.idx
  %.479.i = load double, ptr %scevgep406, align 8, !noalias !9
  %.9.i.i = fcmp ogt double %.343.i, 0.000000e+00
  %49 = fneg double %.479.i
  %"$phi46.2.2.0.p.i.i" = select i1 %.9.i.i, double %49, double %.479.i
  %"$phi46.2.2.0.i.i" = fadd double %"$phi46.2.2.0.p.i.i", 1.000000e+00
  %.12.i.i.i = fcmp olt double %"$phi46.2.2.0.i.i", 0.000000e+00
  %.13.i.i.i = select i1 %.12.i.i.i, double 0.000000e+00, double %"$phi46.2.2.0.i.i"
  %"$phi46.2.2.0.p.i3.i" = select i1 %.9.i.i, double %.479.i, double %49
  %"$phi46.2.2.0.i4.i" = fadd double %"$phi46.2.2.0.p.i3.i", 1.000000e+00
  %.12.i.i5.i = fcmp olt double %"$phi46.2.2.0.i4.i", 0.000000e+00
  %.13.i.i6.i = select i1 %.12.i.i5.i, double 0.000000e+00, double %"$phi46.2.2.0.i4.i"
  %.504.i = fmul double %.416.i, %.13.i.i.i
  %.593.i = fmul double %.416.i, %.13.i.i6.i
  %.625.i = fneg double %.375.i
  %.660.i = fdiv double %.625.i, %.343.i
  store double %.504.i, ptr %scevgep410, align 8, !noalias !9
  store double %.593.i, ptr %scevgep409, align 8, !noalias !9
  store double %.660.i, ptr %scevgep408, align 8, !noalias !9
  br label %B470.i

B704.endif.endif:                                 ; preds = %B470.i, %B704
  %.2682 = add nsw i64 %.251726592726, 1
  %.2696 = icmp slt i64 %.251726592726, -1
  %.2697 = select i1 %.2696, i64 %arg.of_points.5.1, i64 0
  %.2698 = add i64 %.2682, %.2697
  %.2711 = getelementptr double, ptr %arg.of_points.4, i64 %.2698
  %.2712 = load double, ptr %.2711, align 8
  br i1 %.142255.i, label %B72.i, label %part.1

B72.i:                                            ; preds = %B704.endif.endif, %B238.i
  %y.2.0258.i = phi double [ %.540.i, %B238.i ], [ %.2712, %B704.endif.endif ]
  %.141249257.i = phi i64 [ %.151.i, %B238.i ], [ %storemerge.i, %B704.endif.endif ]
  %.151.i = add nsw i64 %.141249257.i, -1
  br i1 %15, label %.thread, label %B90.preheader.i.i

.thread:                                          ; preds = %B72.i
  %.281.i43 = load double, ptr %.520, align 8, !noalias !12
  %.312.i45 = load double, ptr %.660, align 8, !noalias !12
  %.314.i46 = fmul double %y.2.0258.i, %.312.i45
  %.315.i47 = fadd double %.281.i43, %.314.i46
  br label %59

B90.preheader.i.i:                                ; preds = %B72.i
  br i1 %17, label %B90.preheader.i10.i.thread71, label %B90.i.i

B90.preheader.i10.i.thread71:                     ; preds = %B90.preheader.i.i
  %.213.epil.i.i74 = load double, ptr %sunkaddr32.i, align 8, !noalias !15
  %.244.epil.i.i75 = load double, ptr %sunkaddr34.i, align 8, !noalias !15
  %.246.epil.i.i76 = fmul double %y.2.0258.i, %.244.epil.i.i75
  %.247.epil.i.i77 = fadd double %.213.epil.i.i74, %.246.epil.i.i76
  %.253.epil.i.i78 = fcmp one double %.247.epil.i.i77, 0x7FF0000000000000
  %at.3.1.epil.i.i79 = select i1 %.253.epil.i.i78, i64 %unroll_iter.i, i64 0
  %at.2.0.lcssa.i.i.ph.fr80 = freeze i64 %at.3.1.epil.i.i79
  br label %B90.epil.preheader.i39.i

B90.i.i:                                          ; preds = %B90.preheader.i.i, %B90.i.i
  %least.2.0108.i.i = phi double [ %least.3.1.1.i.i, %B90.i.i ], [ 0x7FF0000000000000, %B90.preheader.i.i ]
  %at.2.0107.i.i = phi i64 [ %at.3.1.1.i.i, %B90.i.i ], [ 0, %B90.preheader.i.i ]
  %.138103105.i.i = phi i64 [ %51, %B90.i.i ], [ 0, %B90.preheader.i.i ]
  %sunkaddr22.i = shl i64 %.138103105.i.i, 3
  %sunkaddr23.i = getelementptr i8, ptr %.520, i64 %sunkaddr22.i
  %.213.i.i = load double, ptr %sunkaddr23.i, align 8, !noalias !15
  %sunkaddr25.i = getelementptr i8, ptr %.660, i64 %sunkaddr22.i
  %.244.i.i = load double, ptr %sunkaddr25.i, align 8, !noalias !15
  %.246.i.i = fmul double %y.2.0258.i, %.244.i.i
  %.247.i.i = fadd double %.213.i.i, %.246.i.i
  %.253.i.i = fcmp olt double %.247.i.i, %least.2.0108.i.i
  %at.3.1.i.i = select i1 %.253.i.i, i64 %.138103105.i.i, i64 %at.2.0107.i.i
  %least.3.1.i.i = select i1 %.253.i.i, double %.247.i.i, double %least.2.0108.i.i
  %sunkaddr27.i = getelementptr i8, ptr %sunkaddr23.i, i64 8
  %.213.1.i.i = load double, ptr %sunkaddr27.i, align 8, !noalias !15
  %sunkaddr30.i = getelementptr i8, ptr %sunkaddr25.i, i64 8
  %.244.1.i.i = load double, ptr %sunkaddr30.i, align 8, !noalias !15
  %.246.1.i.i = fmul double %y.2.0258.i, %.244.1.i.i
  %.247.1.i.i = fadd double %.213.1.i.i, %.246.1.i.i
  %.253.1.i.i = fcmp olt double %.247.1.i.i, %least.3.1.i.i
  %50 = or disjoint i64 %.138103105.i.i, 1
  %at.3.1.1.i.i = select i1 %.253.1.i.i, i64 %50, i64 %at.3.1.i.i
  %least.3.1.1.i.i = select i1 %.253.1.i.i, double %.247.1.i.i, double %least.3.1.i.i
  %51 = add i64 %.138103105.i.i, 2
  %niter.ncmp.1.i.i = icmp eq i64 %51, %unroll_iter.i
  br i1 %niter.ncmp.1.i.i, label %B154.loopexit.unr-lcssa.i.i, label %B90.i.i

B154.loopexit.unr-lcssa.i.i:                      ; preds = %B90.i.i
  br i1 %19, label %B90.i13.i.preheader, label %B90.preheader.i10.i

B238.i:                                           ; preds = %59
  %.469.i = fadd double %.281.i51, %.346.i
  %.536.i = fsub double %.378.i2, %.312.i52
  %.540.i = fdiv double %.469.i, %.536.i
  %.142.i = icmp samesign ugt i64 %.141249257.i, 1
  br i1 %.142.i, label %B72.i, label %part.1

B90.preheader.i10.i:                              ; preds = %B154.loopexit.unr-lcssa.i.i
  %.213.epil.i.i = load double, ptr %sunkaddr32.i, align 8, !noalias !15
  %.244.epil.i.i = load double, ptr %sunkaddr34.i, align 8, !noalias !15
  %.246.epil.i.i = fmul double %y.2.0258.i, %.244.epil.i.i
  %.247.epil.i.i = fadd double %.213.epil.i.i, %.246.epil.i.i
  %.253.epil.i.i = fcmp olt double %.247.epil.i.i, %least.3.1.1.i.i
  %at.3.1.epil.i.i = select i1 %.253.epil.i.i, i64 %unroll_iter.i, i64 %at.3.1.1.i.i
  br label %B90.i13.i.preheader

B90.i13.i.preheader:                              ; preds = %B154.loopexit.unr-lcssa.i.i, %B90.preheader.i10.i
  %at.3.1.epil.i.i.sink = phi i64 [ %at.3.1.epil.i.i, %B90.preheader.i10.i ], [ %at.3.1.1.i.i, %B154.loopexit.unr-lcssa.i.i ]
  %at.2.0.lcssa.i.i.ph.fr = freeze i64 %at.3.1.epil.i.i.sink
  br label %B90.i13.i

B90.i13.i:                                        ; preds = %B90.i13.i.preheader, %B90.i13.i
  %least.2.0108.i14.i = phi double [ %least.3.1.1.i35.i, %B90.i13.i ], [ 0x7FF0000000000000, %B90.i13.i.preheader ]
  %at.2.0107.i15.i = phi i64 [ %at.3.1.1.i34.i, %B90.i13.i ], [ 0, %B90.i13.i.preheader ]
  %.138103105.i16.i = phi i64 [ %55, %B90.i13.i ], [ 0, %B90.i13.i.preheader ]
  %sunkaddr35.i = shl i64 %.138103105.i16.i, 3
  %sunkaddr36.i = getelementptr i8, ptr %.590, i64 %sunkaddr35.i
  %.213.i19.i = load double, ptr %sunkaddr36.i, align 8, !noalias !18
  %sunkaddr38.i = getelementptr i8, ptr %.660, i64 %sunkaddr35.i
  %.244.i21.i = load double, ptr %sunkaddr38.i, align 8, !noalias !18
  %52 = fmul double %y.2.0258.i, %.244.i21.i
  %.247.i23.i = fsub double %.213.i19.i, %52
  %.253.i24.i = fcmp olt double %.247.i23.i, %least.2.0108.i14.i
  %at.3.1.i25.i = select i1 %.253.i24.i, i64 %.138103105.i16.i, i64 %at.2.0107.i15.i
  %least.3.1.i26.i = select i1 %.253.i24.i, double %.247.i23.i, double %least.2.0108.i14.i
  %sunkaddr41.i = getelementptr i8, ptr %sunkaddr36.i, i64 8
  %.213.1.i28.i = load double, ptr %sunkaddr41.i, align 8, !noalias !18
  %sunkaddr44.i = getelementptr i8, ptr %sunkaddr38.i, i64 8
  %.244.1.i30.i = load double, ptr %sunkaddr44.i, align 8, !noalias !18
  %53 = fmul double %y.2.0258.i, %.244.1.i30.i
  %.247.1.i32.i = fsub double %.213.1.i28.i, %53
  %.253.1.i33.i = fcmp olt double %.247.1.i32.i, %least.3.1.i26.i
  %54 = or disjoint i64 %.138103105.i16.i, 1
  %at.3.1.1.i34.i = select i1 %.253.1.i33.i, i64 %54, i64 %at.3.1.i25.i
  %least.3.1.1.i35.i = select i1 %.253.1.i33.i, double %.247.1.i32.i, double %least.3.1.i26.i
  %55 = add i64 %.138103105.i16.i, 2
  %niter.ncmp.1.i36.i = icmp eq i64 %55, %unroll_iter.i
  br i1 %niter.ncmp.1.i36.i, label %B154.loopexit.unr-lcssa.i37.i, label %B90.i13.i

B154.loopexit.unr-lcssa.i37.i:                    ; preds = %B90.i13.i
  br i1 %19, label %B72.endif.endif.i, label %B90.epil.preheader.i39.i

B90.epil.preheader.i39.i:                         ; preds = %B90.preheader.i10.i.thread71, %B154.loopexit.unr-lcssa.i37.i
  %at.2.0.lcssa.i.i.ph.fr68 = phi i64 [ %at.2.0.lcssa.i.i.ph.fr80, %B90.preheader.i10.i.thread71 ], [ %at.2.0.lcssa.i.i.ph.fr, %B154.loopexit.unr-lcssa.i37.i ]
  %least.2.0108.epil.init.i40.i = phi double [ 0x7FF0000000000000, %B90.preheader.i10.i.thread71 ], [ %least.3.1.1.i35.i, %B154.loopexit.unr-lcssa.i37.i ]
  %at.2.0107.epil.init.i41.i = phi i64 [ 0, %B90.preheader.i10.i.thread71 ], [ %at.3.1.1.i34.i, %B154.loopexit.unr-lcssa.i37.i ]
  %.213.epil.i43.i = load double, ptr %sunkaddr46.i, align 8, !noalias !18
  %.244.epil.i44.i = load double, ptr %sunkaddr34.i, align 8, !noalias !18
  %56 = fmul double %y.2.0258.i, %.244.epil.i44.i
  %.247.epil.i46.i = fsub double %.213.epil.i43.i, %56
  %.253.epil.i47.i = fcmp olt double %.247.epil.i46.i, %least.2.0108.epil.init.i40.i
  %at.3.1.epil.i48.i = select i1 %.253.epil.i47.i, i64 %unroll_iter.i, i64 %at.2.0107.epil.init.i41.i
  br label %B72.endif.endif.i

B72.endif.endif.i:                                ; preds = %B90.epil.preheader.i39.i, %B154.loopexit.unr-lcssa.i37.i
  %at.2.0.lcssa.i.i.ph.fr69 = phi i64 [ %at.2.0.lcssa.i.i.ph.fr68, %B90.epil.preheader.i39.i ], [ %at.2.0.lcssa.i.i.ph.fr, %B154.loopexit.unr-lcssa.i37.i ]
  %at.2.0.lcssa.i49.i = phi i64 [ %at.3.1.epil.i48.i, %B90.epil.preheader.i39.i ], [ %at.3.1.1.i34.i, %B154.loopexit.unr-lcssa.i37.i ]
  %at.2.0.lcssa.i49.i.fr = freeze i64 %at.2.0.lcssa.i49.i
  %.265.i = icmp slt i64 %at.2.0.lcssa.i.i.ph.fr69, 0
  %spec.select54 = select i1 %.265.i, i64 %arg.of_rows.5.1, i64 0
  %57 = getelementptr double, ptr %.520, i64 %at.2.0.lcssa.i.i.ph.fr69
  %.280.i = getelementptr double, ptr %57, i64 %spec.select54
  %.281.i = load double, ptr %.280.i, align 8, !noalias !12
  %58 = getelementptr double, ptr %.660, i64 %at.2.0.lcssa.i.i.ph.fr69
  %.311.i = getelementptr double, ptr %58, i64 %spec.select54
  %.312.i = load double, ptr %.311.i, align 8, !noalias !12
  %.314.i = fmul double %y.2.0258.i, %.312.i
  %.315.i = fadd double %.281.i, %.314.i
  %.330.i = icmp slt i64 %at.2.0.lcssa.i49.i.fr, 0
  %spec.select55 = select i1 %.330.i, i64 %arg.of_rows.5.1, i64 0
  %.phi.trans.insert = getelementptr double, ptr %.660, i64 %at.2.0.lcssa.i49.i.fr
  %.377.i1.phi.trans.insert = getelementptr double, ptr %.phi.trans.insert, i64 %spec.select55
  %.378.i2.pre = load double, ptr %.377.i1.phi.trans.insert, align 8, !noalias !12
  %.pre = fmul double %y.2.0258.i, %.378.i2.pre
  br label %59

59:                                               ; preds = %B72.endif.endif.i, %.thread
  %.380.i.pre-phi = phi double [ %.pre, %B72.endif.endif.i ], [ %.314.i46, %.thread ]
  %.378.i2 = phi double [ %.378.i2.pre, %B72.endif.endif.i ], [ %.312.i45, %.thread ]
  %.315.i53 = phi double [ %.315.i, %B72.endif.endif.i ], [ %.315.i47, %.thread ]
  %.312.i52 = phi double [ %.312.i, %B72.endif.endif.i ], [ %.312.i45, %.thread ]
  %.281.i51 = phi double [ %.281.i, %B72.endif.endif.i ], [ %.281.i43, %.thread ]
  %at.2.0.lcssa.i49.i3850 = phi i64 [ %at.2.0.lcssa.i49.i.fr, %B72.endif.endif.i ], [ 0, %.thread ]
  %60 = phi i64 [ %spec.select55, %B72.endif.endif.i ], [ 0, %.thread ]
  %61 = getelementptr double, ptr %.590, i64 %at.2.0.lcssa.i49.i3850
  %.345.i = getelementptr double, ptr %61, i64 %60
  %.346.i = load double, ptr %.345.i, align 8, !noalias !12
  %.347.i = fadd double %.315.i53, %.346.i
  %.383.i = fcmp olt double %.347.i, %.380.i.pre-phi
  br i1 %.383.i, label %B238.i, label %part.1

part.1: ; preds = %B238.i, %59, %B704.endif.endif
  %y.2.0245.i = phi double [ %.2712, %B704.endif.endif ], [ %.540.i, %B238.i ], [ %y.2.0258.i, %59 ]
  %.2764 = icmp slt i64 %.251726592726, 0
  %.2765 = select i1 %.2764, i64 %arg.of_points.5.1, i64 0
  %.2766 = add i64 %.2765, %.251726592726
  %.2779 = getelementptr double, ptr %.1091, i64 %.2766
  store double %y.2.0245.i, ptr %.2779, align 8
  %.37.i = fneg double %y.2.0245.i
  br i1 %15, label %B0.endif.endif.i, label %B90.preheader.i.i3

B90.preheader.i.i3:                               ; preds = %part.1
  br i1 %17, label %B90.epil.preheader.i79.i, label %B90.i.i5

B90.i.i5:                                         ; preds = %B90.preheader.i.i3, %B90.i.i5
  %least.2.0108.i.i6 = phi double [ %least.3.1.1.i.i20, %B90.i.i5 ], [ 0x7FF0000000000000, %B90.preheader.i.i3 ]
  %at.2.0107.i.i7 = phi i64 [ %at.3.1.1.i.i19, %B90.i.i5 ], [ 0, %B90.preheader.i.i3 ]
  %.138103105.i.i8 = phi i64 [ %65, %B90.i.i5 ], [ 0, %B90.preheader.i.i3 ]
  %sunkaddr53.i = shl i64 %.138103105.i.i8, 3
  %sunkaddr54.i = getelementptr i8, ptr %.520, i64 %sunkaddr53.i
  %.213.i.i9 = load double, ptr %sunkaddr54.i, align 8, !noalias !21
  %sunkaddr56.i = getelementptr i8, ptr %.660, i64 %sunkaddr53.i
  %.244.i.i10 = load double, ptr %sunkaddr56.i, align 8, !noalias !21
  %62 = fmul double %y.2.0245.i, %.244.i.i10
  %.247.i.i11 = fsub double %.213.i.i9, %62
  %.253.i.i12 = fcmp olt double %.247.i.i11, %least.2.0108.i.i6
  %at.3.1.i.i13 = select i1 %.253.i.i12, i64 %.138103105.i.i8, i64 %at.2.0107.i.i7
  %least.3.1.i.i14 = select i1 %.253.i.i12, double %.247.i.i11, double %least.2.0108.i.i6
  %sunkaddr58.i = getelementptr i8, ptr %sunkaddr54.i, i64 8
  %.213.1.i.i15 = load double, ptr %sunkaddr58.i, align 8, !noalias !21
  %sunkaddr61.i = getelementptr i8, ptr %sunkaddr56.i, i64 8
  %.244.1.i.i16 = load double, ptr %sunkaddr61.i, align 8, !noalias !21
  %63 = fmul double %y.2.0245.i, %.244.1.i.i16
  %.247.1.i.i17 = fsub double %.213.1.i.i15, %63
  %.253.1.i.i18 = fcmp olt double %.247.1.i.i17, %least.3.1.i.i14
  %64 = or disjoint i64 %.138103105.i.i8, 1
  %at.3.1.1.i.i19 = select i1 %.253.1.i.i18, i64 %64, i64 %at.3.1.i.i13
  %least.3.1.1.i.i20 = select i1 %.253.1.i.i18, double %.247.1.i.i17, double %least.3.1.i.i14
  %65 = add i64 %.138103105.i.i8, 2
  %niter.ncmp.1.i.i21 = icmp eq i64 %65, %unroll_iter.i
  br i1 %niter.ncmp.1.i.i21, label %B154.loopexit.unr-lcssa.i.i22, label %B90.i.i5

B154.loopexit.unr-lcssa.i.i22:                    ; preds = %B90.i.i5
  br i1 %19, label %B90.preheader.new.i51.i, label %B90.preheader.i50.B90.preheader.new.i51_crit_edge.i

B98.i:                                            ; preds = %B0.endif.endif.i
  %66 = getelementptr double, ptr %.520, i64 %at.2.0.lcssa.i93.fr.i
  %.175.i = getelementptr double, ptr %66, i64 %.123.i
  %.176.i = load double, ptr %.175.i, align 8, !noalias !26
  %sunkaddr316.i = shl i64 %.123.i, 3
  %sunkaddr317.i = getelementptr inbounds i8, ptr %84, i64 %sunkaddr316.i
  %.212.i = load double, ptr %sunkaddr317.i, align 8, !noalias !26
  %.221.i = fmul double %y.2.0245.i, %.212.i
  %.224.i = fsub double %.176.i, %.221.i
  br label %part.2

B144.i:                                           ; preds = %B0.endif.endif.i
  %.259.i = icmp slt i64 %at.2.0.lcssa.i89.i, 0
  %.260.i = select i1 %.259.i, i64 %arg.of_rows.5.1, i64 0
  %67 = getelementptr double, ptr %.520, i64 %at.2.0.lcssa.i89.i
  %.274.i = getelementptr double, ptr %67, i64 %.260.i
  %.275.i = load double, ptr %.274.i, align 8, !noalias !26
  %68 = getelementptr double, ptr %.660, i64 %at.2.0.lcssa.i89.i
  %.305.i = getelementptr double, ptr %68, i64 %.260.i
  %.306.i = load double, ptr %.305.i, align 8, !noalias !26
  %.308.i = fmul double %y.2.0245.i, %.306.i
  %.309.i = fadd double %.275.i, %.308.i
  %.349.i = fcmp uge double %.306.i, 0.000000e+00
  %or.cond411.i = or i1 %15, %.349.i
  br i1 %or.cond411.i, label %part.2, label %B270.preheader.i

B270.preheader.i:                                 ; preds = %B144.i
  br i1 %17, label %B270.preheader.split.us.i, label %B270.i

B270.preheader.split.us.i:                        ; preds = %B270.preheader.i
  %.749.us.i = load double, ptr %.660, align 8, !noalias !26
  %.749.us.fr.i = freeze double %.749.us.i
  %.788.us.i = fcmp ogt double %.749.us.fr.i, 0.000000e+00
  br i1 %.788.us.i, label %B270.us.us184.preheader.i, label %B270.preheader.split.us.split.us.i

B270.preheader.split.us.split.us.i:               ; preds = %B270.preheader.split.us.i
  %.841.us.i = fcmp olt double %.749.us.fr.i, 0.000000e+00
  br i1 %.841.us.i, label %B270.us.us.preheader.i, label %B500.split.us.i

B270.us.us.preheader.i:                           ; preds = %B270.preheader.split.us.split.us.i
  %.845.us.us.not.peel.i = icmp eq i64 %at.2.0.lcssa.i89.i, 0
  br i1 %.845.us.us.not.peel.i, label %B500.split.us.i, label %B268.B502.loopexit_crit_edge.split.us.i

B270.us.us184.preheader.i:                        ; preds = %B270.preheader.split.us.i
  %.792.us.us.not.peel.i = icmp eq i64 %at.2.0.lcssa.i93.fr.i, 0
  br i1 %.792.us.us.not.peel.i, label %B500.split.us.i, label %B268.B502.loopexit_crit_edge.split.us.i

B500.split.us.i:                                  ; preds = %B270.us.us184.preheader.i, %B270.us.us.preheader.i, %B270.preheader.split.us.split.us.i
  %.us-phi166.i = phi i64 [ %at.2.0.lcssa.i89.i, %B270.preheader.split.us.split.us.i ], [ %at.2.0.lcssa.i89.i, %B270.us.us184.preheader.i ], [ 0, %B270.us.us.preheader.i ]
  %.us-phi166.fr.i = freeze i64 %.us-phi166.i
  %.us-phi166.lobit.i = lshr i64 %.us-phi166.fr.i, 63
  %69 = getelementptr double, ptr %.520, i64 %.us-phi166.fr.i
  %.549.us.le.i = getelementptr double, ptr %69, i64 %.us-phi166.lobit.i
  %.550.us.le153.i = load double, ptr %.549.us.le.i, align 8, !noalias !26
  %.us-phi168.lobit.i = lshr i64 %at.2.0.lcssa.i93.fr.i, 63
  %70 = getelementptr double, ptr %.520, i64 %at.2.0.lcssa.i93.fr.i
  %.580.us.le.i = getelementptr double, ptr %70, i64 %.us-phi168.lobit.i
  %.581.us.le140.i = load double, ptr %.580.us.le.i, align 8, !noalias !26
  %.582.us.le.i = fsub double %.550.us.le153.i, %.581.us.le140.i
  %.us-phi166.fr.i.lobit = lshr i64 %.us-phi166.fr.i, 63
  %71 = getelementptr double, ptr %.660, i64 %.us-phi166.fr.i
  %.643.us.le.i = getelementptr double, ptr %71, i64 %.us-phi166.fr.i.lobit
  %.644.us.le121.i = load double, ptr %.643.us.le.i, align 8, !noalias !26
  %.645.us.le.i = fsub double %.138.i, %.644.us.le121.i
  %.649.us.le115.i = fdiv double %.582.us.le.i, %.645.us.le.i
  br label %B500.i

B268.B502.loopexit_crit_edge.split.us.i:          ; preds = %B270.us.us184.preheader.i, %B270.us.us.preheader.i
  %at.2.0.lcssa.i89.lobit.i = lshr i64 %at.2.0.lcssa.i89.i, 63
  %.549.us.le155.i = getelementptr double, ptr %67, i64 %at.2.0.lcssa.i89.lobit.i
  %.550.us.le.i = load double, ptr %.549.us.le155.i, align 8, !noalias !26
  %at.2.0.lcssa.i93.lobit.i = lshr i64 %at.2.0.lcssa.i93.fr.i, 63
  %72 = getelementptr double, ptr %.520, i64 %at.2.0.lcssa.i93.fr.i
  %.580.us.le142.i = getelementptr double, ptr %72, i64 %at.2.0.lcssa.i93.lobit.i
  %.581.us.le.i = load double, ptr %.580.us.le142.i, align 8, !noalias !26
  %.582.us.le137.i = fsub double %.550.us.le.i, %.581.us.le.i
  %.645.us.le118.i = fsub double %.138.i, %.306.i
  %.649.us.le.i = fdiv double %.582.us.le137.i, %.645.us.le118.i
  br label %B268.B502.loopexit_crit_edge.i

B270.i:                                           ; preds = %B270.preheader.i, %B503.i
  %left.2.1389.i = phi i64 [ %left.3.1.i, %B503.i ], [ %at.2.0.lcssa.i93.fr.i, %B270.preheader.i ]
  %right.2.1388.i = phi i64 [ %right.3.1.i, %B503.i ], [ %at.2.0.lcssa.i89.i, %B270.preheader.i ]
  %.477381387.i = phi i64 [ %.487.i, %B503.i ], [ %arg.of_rows.5.1, %B270.preheader.i ]
  %.534.i = icmp slt i64 %right.2.1388.i, 0
  %.535.i = select i1 %.534.i, i64 %arg.of_rows.5.1, i64 0
  %73 = getelementptr double, ptr %.520, i64 %right.2.1388.i
  %.549.i = getelementptr double, ptr %73, i64 %.535.i
  %.550.i = load double, ptr %.549.i, align 8, !noalias !26
  %.565.i = icmp slt i64 %left.2.1389.i, 0
  %.566.i = select i1 %.565.i, i64 %arg.of_rows.5.1, i64 0
  %74 = getelementptr double, ptr %.520, i64 %left.2.1389.i
  %.580.i = getelementptr double, ptr %74, i64 %.566.i
  %.581.i = load double, ptr %.580.i, align 8, !noalias !26
  %.582.i = fsub double %.550.i, %.581.i
  %75 = getelementptr double, ptr %.660, i64 %left.2.1389.i
  %.612.i = getelementptr double, ptr %75, i64 %.566.i
  %.613.i = load double, ptr %.612.i, align 8, !noalias !26
  %76 = getelementptr double, ptr %.660, i64 %right.2.1388.i
  %.643.i = getelementptr double, ptr %76, i64 %.535.i
  %.644.i = load double, ptr %.643.i, align 8, !noalias !26
  %.645.i = fsub double %.613.i, %.644.i
  %.649.i = fdiv double %.582.i, %.645.i
  br label %B90.i11.i

B90.i11.i:                                        ; preds = %B90.i11.i, %B270.i
  %least.2.0108.i12.i = phi double [ 0x7FF0000000000000, %B270.i ], [ %least.3.1.1.i33.i, %B90.i11.i ]
  %at.2.0107.i13.i = phi i64 [ 0, %B270.i ], [ %at.3.1.1.i32.i, %B90.i11.i ]
  %.138103105.i14.i = phi i64 [ 0, %B270.i ], [ %78, %B90.i11.i ]
  %sunkaddr62.i = shl i64 %.138103105.i14.i, 3
  %sunkaddr63.i = getelementptr i8, ptr %.520, i64 %sunkaddr62.i
  %.213.i17.i = load double, ptr %sunkaddr63.i, align 8, !noalias !27
  %sunkaddr65.i = getelementptr i8, ptr %.660, i64 %sunkaddr62.i
  %.244.i19.i = load double, ptr %sunkaddr65.i, align 8, !noalias !27
  %.246.i20.i = fmul double %.649.i, %.244.i19.i
  %.247.i21.i = fadd double %.213.i17.i, %.246.i20.i
  %.253.i22.i = fcmp olt double %.247.i21.i, %least.2.0108.i12.i
  %at.3.1.i23.i = select i1 %.253.i22.i, i64 %.138103105.i14.i, i64 %at.2.0107.i13.i
  %least.3.1.i24.i = select i1 %.253.i22.i, double %.247.i21.i, double %least.2.0108.i12.i
  %sunkaddr68.i = getelementptr i8, ptr %sunkaddr63.i, i64 8
  %.213.1.i26.i = load double, ptr %sunkaddr68.i, align 8, !noalias !27
  %sunkaddr71.i = getelementptr i8, ptr %sunkaddr65.i, i64 8
  %.244.1.i28.i = load double, ptr %sunkaddr71.i, align 8, !noalias !27
  %.246.1.i29.i = fmul double %.649.i, %.244.1.i28.i
  %.247.1.i30.i = fadd double %.213.1.i26.i, %.246.1.i29.i
  %.253.1.i31.i = fcmp olt double %.247.1.i30.i, %least.3.1.i24.i
  %77 = or disjoint i64 %.138103105.i14.i, 1
  %at.3.1.1.i32.i = select i1 %.253.1.i31.i, i64 %77, i64 %at.3.1.i23.i
  %least.3.1.1.i33.i = select i1 %.253.1.i31.i, double %.247.1.i30.i, double %least.3.1.i24.i
  %78 = add i64 %.138103105.i14.i, 2
  %niter.ncmp.1.i34.i = icmp eq i64 %78, %unroll_iter.i
  br i1 %niter.ncmp.1.i34.i, label %B154.loopexit.unr-lcssa.i35.i, label %B90.i11.i

B154.loopexit.unr-lcssa.i35.i:                    ; preds = %B90.i11.i
  %.487.i = add nsw i64 %.477381387.i, -1
  br i1 %19, label %B270.endif.endif.i, label %B90.epil.preheader.i37.i

B90.epil.preheader.i37.i:                         ; preds = %B154.loopexit.unr-lcssa.i35.i
  %.213.epil.i41.i = load double, ptr %sunkaddr32.i, align 8, !noalias !27
  %.244.epil.i42.i = load double, ptr %sunkaddr34.i, align 8, !noalias !27
  %.246.epil.i43.i = fmul double %.649.i, %.244.epil.i42.i
  %.247.epil.i44.i = fadd double %.213.epil.i41.i, %.246.epil.i43.i
  %.253.epil.i45.i = fcmp olt double %.247.epil.i44.i, %least.3.1.1.i33.i
  %at.3.1.epil.i46.i = select i1 %.253.epil.i45.i, i64 %unroll_iter.i, i64 %at.3.1.1.i32.i
  br label %B270.endif.endif.i

B458.i:                                           ; preds = %B270.endif.endif.i
  %.841.i = fcmp olt double %.749.i, 0.000000e+00
  %.845.i = icmp ne i64 %at.2.0.lcssa.i47.i, %right.2.1388.i
  %or.cond370.i = and i1 %.845.i, %.841.i
  br i1 %or.cond370.i, label %B503.i, label %B500.i

B500.i:                                           ; preds = %B458.i, %B500.split.us.i
  %.us-phi.i = phi i64 [ 0, %B500.split.us.i ], [ %.734.i, %B458.i ]
  %.us-phi108.i = phi i64 [ 0, %B500.split.us.i ], [ %at.2.0.lcssa.i47.i, %B458.i ]
  %.us-phi109.i = phi double [ %.749.us.fr.i, %B500.split.us.i ], [ %.749.i, %B458.i ]
  %.us-phi110.i = phi double [ %.649.us.le115.i, %B500.split.us.i ], [ %.649.i, %B458.i ]
  %79 = getelementptr double, ptr %.520, i64 %.us-phi108.i
  %.717.le.i = getelementptr double, ptr %79, i64 %.us-phi.i
  %.718.le100.i = load double, ptr %.717.le.i, align 8, !noalias !26
  %.751.le.i = fmul double %.us-phi109.i, %.us-phi110.i
  %.752.le393.i = fadd double %.718.le100.i, %.751.le.i
  br label %part.2

B268.B502.loopexit_crit_edge.i:                   ; preds = %B503.i, %B268.B502.loopexit_crit_edge.split.us.i
  %.us-phi111.i = phi i64 [ 0, %B268.B502.loopexit_crit_edge.split.us.i ], [ %.734.i, %B503.i ]
  %.us-phi112.i = phi i64 [ 0, %B268.B502.loopexit_crit_edge.split.us.i ], [ %at.2.0.lcssa.i47.i, %B503.i ]
  %.us-phi113.i = phi double [ %.749.us.fr.i, %B268.B502.loopexit_crit_edge.split.us.i ], [ %.749.i, %B503.i ]
  %.us-phi114.i = phi double [ %.649.us.le.i, %B268.B502.loopexit_crit_edge.split.us.i ], [ %.649.i, %B503.i ]
  %80 = getelementptr double, ptr %.520, i64 %.us-phi112.i
  %.717.le102.i = getelementptr double, ptr %80, i64 %.us-phi111.i
  %.718.le.i = load double, ptr %.717.le102.i, align 8, !noalias !26
  %.751.le396.i = fmul double %.us-phi113.i, %.us-phi114.i
  %.752.le.i = fadd double %.718.le.i, %.751.le396.i
  br label %part.2

B503.i:                                           ; preds = %B270.endif.endif.i, %B458.i
  %right.3.1.i = phi i64 [ %right.2.1388.i, %B270.endif.endif.i ], [ %at.2.0.lcssa.i47.i, %B458.i ]
  %left.3.1.i = phi i64 [ %at.2.0.lcssa.i47.i, %B270.endif.endif.i ], [ %left.2.1389.i, %B458.i ]
  %.478.i = icmp samesign ugt i64 %.477381387.i, 1
  br i1 %.478.i, label %B270.i, label %B268.B502.loopexit_crit_edge.i

B90.preheader.i50.B90.preheader.new.i51_crit_edge.i: ; preds = %B154.loopexit.unr-lcssa.i.i22
  %.213.epil.i.i23 = load double, ptr %20, align 8, !noalias !21
  %.244.epil.i.i24 = load double, ptr %21, align 8, !noalias !21
  %81 = fmul double %y.2.0245.i, %.244.epil.i.i24
  %.247.epil.i.i25 = fsub double %.213.epil.i.i23, %81
  %.253.epil.i.i26 = fcmp olt double %.247.epil.i.i25, %least.3.1.1.i.i20
  %at.3.1.epil.i.i27 = select i1 %.253.epil.i.i26, i64 %unroll_iter.i, i64 %at.3.1.1.i.i19
  br label %B90.preheader.new.i51.i

B90.preheader.new.i51.i:                          ; preds = %B90.preheader.i50.B90.preheader.new.i51_crit_edge.i, %B154.loopexit.unr-lcssa.i.i22
  %at.2.0.lcssa.i.ph95.i = phi i64 [ %at.3.1.epil.i.i27, %B90.preheader.i50.B90.preheader.new.i51_crit_edge.i ], [ %at.3.1.1.i.i19, %B154.loopexit.unr-lcssa.i.i22 ]
  br label %B90.i53.i

B90.i53.i:                                        ; preds = %B90.i53.i, %B90.preheader.new.i51.i
  %least.2.0108.i54.i = phi double [ 0x7FF0000000000000, %B90.preheader.new.i51.i ], [ %least.3.1.1.i75.i, %B90.i53.i ]
  %at.2.0107.i55.i = phi i64 [ 0, %B90.preheader.new.i51.i ], [ %at.3.1.1.i74.i, %B90.i53.i ]
  %.138103105.i56.i = phi i64 [ 0, %B90.preheader.new.i51.i ], [ %83, %B90.i53.i ]
  %sunkaddr76.i = shl i64 %.138103105.i56.i, 3
  %sunkaddr77.i = getelementptr i8, ptr %.520, i64 %sunkaddr76.i
  %.213.i59.i = load double, ptr %sunkaddr77.i, align 8, !noalias !30
  %sunkaddr79.i = getelementptr i8, ptr %.660, i64 %sunkaddr76.i
  %.244.i61.i = load double, ptr %sunkaddr79.i, align 8, !noalias !30
  %.246.i62.i = fmul double %y.2.0245.i, %.244.i61.i
  %.247.i63.i = fadd double %.213.i59.i, %.246.i62.i
  %.253.i64.i = fcmp olt double %.247.i63.i, %least.2.0108.i54.i
  %at.3.1.i65.i = select i1 %.253.i64.i, i64 %.138103105.i56.i, i64 %at.2.0107.i55.i
  %least.3.1.i66.i = select i1 %.253.i64.i, double %.247.i63.i, double %least.2.0108.i54.i
  %sunkaddr82.i = getelementptr i8, ptr %sunkaddr77.i, i64 8
  %.213.1.i68.i = load double, ptr %sunkaddr82.i, align 8, !noalias !30
  %sunkaddr85.i = getelementptr i8, ptr %sunkaddr79.i, i64 8
  %.244.1.i70.i = load double, ptr %sunkaddr85.i, align 8, !noalias !30
  %.246.1.i71.i = fmul double %y.2.0245.i, %.244.1.i70.i
  %.247.1.i72.i = fadd double %.213.1.i68.i, %.246.1.i71.i
  %.253.1.i73.i = fcmp olt double %.247.1.i72.i, %least.3.1.i66.i
  %82 = or disjoint i64 %.138103105.i56.i, 1
  %at.3.1.1.i74.i = select i1 %.253.1.i73.i, i64 %82, i64 %at.3.1.i65.i
  %least.3.1.1.i75.i = select i1 %.253.1.i73.i, double %.247.1.i72.i, double %least.3.1.i66.i
  %83 = add i64 %.138103105.i56.i, 2
  %niter.ncmp.1.i76.i = icmp eq i64 %83, %unroll_iter.i
  br i1 %niter.ncmp.1.i76.i, label %B154.loopexit.unr-lcssa.i77.i, label %B90.i53.i

B154.loopexit.unr-lcssa.i77.i:                    ; preds = %B90.i53.i
  br i1 %19, label %B0.endif.endif.i, label %B90.epil.preheader.i79.i

B90.epil.preheader.i79.i:                         ; preds = %B154.loopexit.unr-lcssa.i77.i, %B90.preheader.i.i3
  %at.2.0.lcssa.i.ph96.i = phi i64 [ %at.2.0.lcssa.i.ph95.i, %B154.loopexit.unr-lcssa.i77.i ], [ 0, %B90.preheader.i.i3 ]
  %least.2.0108.epil.init.i80.i = phi double [ %least.3.1.1.i75.i, %B154.loopexit.unr-lcssa.i77.i ], [ 0x7FF0000000000000, %B90.preheader.i.i3 ]
  %at.2.0107.epil.init.i81.i = phi i64 [ %at.3.1.1.i74.i, %B154.loopexit.unr-lcssa.i77.i ], [ 0, %B90.preheader.i.i3 ]
  %.213.epil.i83.i = load double, ptr %20, align 8, !noalias !30
  %.244.epil.i84.i = load double, ptr %21, align 8, !noalias !30
  %.246.epil.i85.i = fmul double %y.2.0245.i, %.244.epil.i84.i
  %.247.epil.i86.i = fadd double %.213.epil.i83.i, %.246.epil.i85.i
  %.253.epil.i87.i = fcmp olt double %.247.epil.i86.i, %least.2.0108.epil.init.i80.i
  %at.3.1.epil.i88.i = select i1 %.253.epil.i87.i, i64 %unroll_iter.i, i64 %at.2.0107.epil.init.i81.i
  br label %B0.endif.endif.i

B0.endif.endif.i:                                 ; preds = %B90.epil.preheader.i79.i, %B154.loopexit.unr-lcssa.i77.i, %part.1
  %at.2.0.lcssa.i93.i = phi i64 [ %at.2.0.lcssa.i.ph96.i, %B90.epil.preheader.i79.i ], [ %at.2.0.lcssa.i.ph95.i, %B154.loopexit.unr-lcssa.i77.i ], [ 0, %part.1 ]
  %at.2.0.lcssa.i89.i = phi i64 [ %at.3.1.epil.i88.i, %B90.epil.preheader.i79.i ], [ %at.3.1.1.i74.i, %B154.loopexit.unr-lcssa.i77.i ], [ 0, %part.1 ]
  %at.2.0.lcssa.i93.fr.i = freeze i64 %at.2.0.lcssa.i93.i
  %.122.i = icmp slt i64 %at.2.0.lcssa.i93.fr.i, 0
  %.123.i = select i1 %.122.i, i64 %arg.of_rows.5.1, i64 0
  %84 = getelementptr double, ptr %.660, i64 %at.2.0.lcssa.i93.fr.i
  %.137.i = getelementptr double, ptr %84, i64 %.123.i
  %.138.i = load double, ptr %.137.i, align 8, !noalias !26
  %.140.i = fcmp ogt double %.138.i, 0.000000e+00
  br i1 %.140.i, label %B144.i, label %B98.i

B270.endif.endif.i:                               ; preds = %B90.epil.preheader.i37.i, %B154.loopexit.unr-lcssa.i35.i
  %at.2.0.lcssa.i47.i = phi i64 [ %at.3.1.epil.i46.i, %B90.epil.preheader.i37.i ], [ %at.3.1.1.i32.i, %B154.loopexit.unr-lcssa.i35.i ]
  %.702.i = icmp slt i64 %at.2.0.lcssa.i47.i, 0
  %.734.i = select i1 %.702.i, i64 %arg.of_rows.5.1, i64 0
  %85 = getelementptr double, ptr %.660, i64 %at.2.0.lcssa.i47.i
  %.748.i = getelementptr double, ptr %85, i64 %.734.i
  %.749.i = load double, ptr %.748.i, align 8, !noalias !26
  %.788.i = fcmp ogt double %.749.i, 0.000000e+00
  %.792.i = icmp ne i64 %at.2.0.lcssa.i47.i, %left.2.1389.i
  %or.cond.i = and i1 %.792.i, %.788.i
  br i1 %or.cond.i, label %B503.i, label %B458.i

part.2: ; preds = %B98.i, %B144.i, %B500.i, %B268.B502.loopexit_crit_edge.i
  %y.2.0.sink.i = phi double [ %.37.i, %B98.i ], [ %.us-phi110.i, %B500.i ], [ %y.2.0245.i, %B144.i ], [ %.us-phi114.i, %B268.B502.loopexit_crit_edge.i ]
  %x.2.0.sink.i = phi double [ %.224.i, %B98.i ], [ %.752.le393.i, %B500.i ], [ %.309.i, %B144.i ], [ %.752.le.i, %B268.B502.loopexit_crit_edge.i ]
  %.2853 = getelementptr double, ptr %arg.of_points.4, i64 %.2766
  %.2854 = load double, ptr %.2853, align 8
  %.12.i253 = fcmp olt double %.2854, %x.2.0.sink.i
  %.13.i254 = select i1 %.12.i253, double %.2854, double %x.2.0.sink.i
  %.2916 = getelementptr double, ptr %.1021, i64 %.2766
  store double %.13.i254, ptr %.2916, align 8
  br i1 %15, label %B1614.endif.endif.endif.endif, label %B1008.preheader

B1008.preheader:                                  ; preds = %part.2
  %sunkaddr468 = shl i64 %.2766, 3
  %sunkaddr469 = getelementptr i8, ptr %arg.of_points.4, i64 %sunkaddr468
  %sunkaddr472 = shl i64 %.2698, 3
  %sunkaddr473 = getelementptr i8, ptr %.1231, i64 %sunkaddr472
  br label %B1008

B1214.endif.endif.endif.endif:                    ; preds = %B1150
  %.3226 = load double, ptr %sunkaddr469, align 8
  %.3258 = load double, ptr %sunkaddr438, align 8
  %scevgep415 = getelementptr i8, ptr %lsr.iv412, i64 %.450.idx
  %.3289 = load double, ptr %scevgep415, align 8
  %.9.i = fcmp ogt double %.3258, 0.000000e+00
  %86 = fneg double %.3289
  %"$phi46.2.2.0.p.i" = select i1 %.9.i, double %86, double %.3289
  %"$phi46.2.2.0.i" = fadd double %"$phi46.2.2.0.p.i", 1.000000e+00
  %.12.i.i = fcmp olt double %"$phi46.2.2.0.i", 0.000000e+00
  %.13.i.i = select i1 %.12.i.i, double 0.000000e+00, double %"$phi46.2.2.0.i"
  %.3315 = fsub double %.13.i.i, %.3116
  %.12.i255 = fcmp olt double %.3315, 0.000000e+00
  %.13.i256 = select i1 %.12.i255, double 0.000000e+00, double %.3315
  %.3379 = tail call double @llvm.fabs.f64(double %.3258)
  %.3383 = fdiv double %.13.i256, %.3379
  %.12.i257 = fcmp olt double %.3383, %.3226
  %.13.i258 = select i1 %.12.i257, double %.3383, double %.3226
  store double %.13.i258, ptr %sunkaddr469, align 8
  br label %B3567

B1418.endif.endif.endif.endif:                    ; preds = %B1396
  %.3480 = load double, ptr %sunkaddr473, align 8
  %.3512 = load double, ptr %lsr.iv412, align 8
  %scevgep414 = getelementptr i8, ptr %lsr.iv412, i64 %.450.idx
  %.3543 = load double, ptr %scevgep414, align 8
  %.9.i233 = fcmp ogt double %.3512, 0.000000e+00
  %87 = fneg double %.3543
  %"$phi46.2.2.0.p.i234" = select i1 %.9.i233, double %87, double %.3543
  %"$phi46.2.2.0.i235" = fadd double %"$phi46.2.2.0.p.i234", 1.000000e+00
  %.12.i.i236 = fcmp olt double %"$phi46.2.2.0.i235", 0.000000e+00
  %.13.i.i237 = select i1 %.12.i.i236, double 0.000000e+00, double %"$phi46.2.2.0.i235"
  %.3569 = fsub double %.13.i.i237, %.3082
  %.12.i259 = fcmp olt double %.3569, 0.000000e+00
  %.13.i260 = select i1 %.12.i259, double 0.000000e+00, double %.3569
  %.3633 = tail call double @llvm.fabs.f64(double %.3512)
  %.3637 = fdiv double %.13.i260, %.3633
  %.12.i261 = fcmp olt double %.3637, %.3480
  %.13.i262 = select i1 %.12.i261, double %.3637, double %.3480
  store double %.13.i262, ptr %sunkaddr473, align 8
  br label %B3567

B1614.endif.endif.endif.endif:                    ; preds = %B3567, %part.2
  %.3740 = getelementptr double, ptr %.1231, i64 %.2698
  %.3741 = load double, ptr %.3740, align 8
  %.12.i238 = fcmp olt double %y.2.0245.i, %.3741
  %.13.i239 = select i1 %.12.i238, double %y.2.0245.i, double %.3741
  store double %.13.i239, ptr %.3740, align 8
  %.3835 = getelementptr double, ptr %.1161, i64 %.2698
  %.3836 = load double, ptr %.3835, align 8
  %.3871 = fmul double %.13.i239, 0x3FF000000044B830
  %.3872 = fcmp ogt double %.3836, %.3871
  %.3874 = or i1 %failed.5.12728, %.3872
  %.12.i263 = fcmp olt double %.13.i239, %.3836
  %.13.i264 = select i1 %.12.i263, double %.13.i239, double %.3836
  store double %.13.i264, ptr %.3835, align 8
  %.12.i265 = fcmp ogt double %.13.i264, %y.2.0.sink.i
  %.13.i266 = select i1 %.12.i265, double %.13.i264, double %y.2.0.sink.i
  %.4100 = load double, ptr %.3740, align 8
  %.12.i267 = fcmp olt double %.4100, %.13.i266
  %.13.i268 = select i1 %.12.i267, double %.4100, double %.13.i266
  br i1 %15, label %B1614.endif.endif.endif.endif.endif.endif.thread, label %B90.preheader.i

B90.preheader.i:                                  ; preds = %B1614.endif.endif.endif.endif
  br i1 %17, label %B90.epil.preheader.i, label %B90.i

B90.i:                                            ; preds = %B90.preheader.i, %B90.i
  %least.2.0108.i = phi double [ %least.3.1.1.i, %B90.i ], [ 0x7FF0000000000000, %B90.preheader.i ]
  %at.2.0107.i = phi i64 [ %at.3.1.1.i, %B90.i ], [ 0, %B90.preheader.i ]
  %.138103105.i = phi i64 [ %89, %B90.i ], [ 0, %B90.preheader.i ]
  %sunkaddr.i = shl i64 %.138103105.i, 3
  %scevgep427 = getelementptr i8, ptr %scevgep425, i64 %sunkaddr.i
  %scevgep428 = getelementptr i8, ptr %scevgep427, i64 -8
  %.213.i = load double, ptr %scevgep428, align 8, !noalias !33
  %scevgep423 = getelementptr i8, ptr %scevgep421, i64 %sunkaddr.i
  %scevgep424 = getelementptr i8, ptr %scevgep423, i64 -8
  %.244.i = load double, ptr %scevgep424, align 8, !noalias !33
  %.246.i = fmul double %.13.i268, %.244.i
  %.247.i = fadd double %.213.i, %.246.i
  %.253.i = fcmp olt double %.247.i, %least.2.0108.i
  %at.3.1.i = select i1 %.253.i, i64 %.138103105.i, i64 %at.2.0107.i
  %least.3.1.i = select i1 %.253.i, double %.247.i, double %least.2.0108.i
  %.213.1.i = load double, ptr %scevgep427, align 8, !noalias !33
  %.244.1.i = load double, ptr %scevgep423, align 8, !noalias !33
  %.246.1.i = fmul double %.13.i268, %.244.1.i
  %.247.1.i = fadd double %.213.1.i, %.246.1.i
  %.253.1.i = fcmp olt double %.247.1.i, %least.3.1.i
  %88 = or disjoint i64 %.138103105.i, 1
  %at.3.1.1.i = select i1 %.253.1.i, i64 %88, i64 %at.3.1.i
  %least.3.1.1.i = select i1 %.253.1.i, double %.247.1.i, double %least.3.1.i
  %89 = add i64 %.138103105.i, 2
  %niter.ncmp.1.i = icmp eq i64 %89, %unroll_iter.i
  br i1 %niter.ncmp.1.i, label %B154.loopexit.unr-lcssa.i, label %B90.i

B154.loopexit.unr-lcssa.i:                        ; preds = %B90.i
  br i1 %19, label %B1614.endif.endif.endif.endif.endif.endif, label %B90.epil.preheader.i

B90.epil.preheader.i:                             ; preds = %B154.loopexit.unr-lcssa.i, %B90.preheader.i
  %least.2.0108.epil.init.i = phi double [ 0x7FF0000000000000, %B90.preheader.i ], [ %least.3.1.1.i, %B154.loopexit.unr-lcssa.i ]
  %at.2.0107.epil.init.i = phi i64 [ 0, %B90.preheader.i ], [ %at.3.1.1.i, %B154.loopexit.unr-lcssa.i ]
  %.213.epil.i = load double, ptr %sunkaddr32.i, align 8, !noalias !33
  %.244.epil.i = load double, ptr %sunkaddr34.i, align 8, !noalias !33
  %.246.epil.i = fmul double %.13.i268, %.244.epil.i
  %.247.epil.i = fadd double %.213.epil.i, %.246.epil.i
  %.253.epil.i = fcmp olt double %.247.epil.i, %least.2.0108.epil.init.i
  br i1 %.253.epil.i, label %B1614.endif.endif.endif.endif.endif.endif.thread, label %B1614.endif.endif.endif.endif.endif.endif

B1614.endif.endif.endif.endif.endif.endif.thread: ; preds = %B90.epil.preheader.i, %B1614.endif.endif.endif.endif
  %at.2.0.lcssa.i.ph = phi i64 [ 0, %B1614.endif.endif.endif.endif ], [ %unroll_iter.i, %B90.epil.preheader.i ]
  %sunkaddr478 = shl i64 %.2766, 3
  %sunkaddr479 = getelementptr i8, ptr %arg.of_points.4, i64 %sunkaddr478
  %.4190324 = load double, ptr %sunkaddr479, align 8
  %.12.i269325 = fcmp olt double %.4190324, %.13.i254
  %.13.i270326 = select i1 %.12.i269325, double %.4190324, double %.13.i254
  br label %B1614.endif.endif.endif.endif.endif.endif.endif

B1614.endif.endif.endif.endif.endif.endif:        ; preds = %B90.epil.preheader.i, %B154.loopexit.unr-lcssa.i
  %at.2.0.lcssa.i = phi i64 [ %at.2.0107.epil.init.i, %B90.epil.preheader.i ], [ %at.3.1.1.i, %B154.loopexit.unr-lcssa.i ]
  %at.2.0.lcssa.i.fr = freeze i64 %at.2.0.lcssa.i
  %sunkaddr480 = shl i64 %.2766, 3
  %sunkaddr481 = getelementptr i8, ptr %arg.of_points.4, i64 %sunkaddr480
  %.4190 = load double, ptr %sunkaddr481, align 8
  %.12.i269 = fcmp olt double %.4190, %.13.i254
  %.13.i270 = select i1 %.12.i269, double %.4190, double %.13.i254
  %.4235 = icmp slt i64 %at.2.0.lcssa.i.fr, 0
  %spec.select = select i1 %.4235, i64 %arg.of_rows.5.1, i64 0
  br label %B1614.endif.endif.endif.endif.endif.endif.endif

B1614.endif.endif.endif.endif.endif.endif.endif:  ; preds = %B1614.endif.endif.endif.endif.endif.endif, %B1614.endif.endif.endif.endif.endif.endif.thread
  %.13.i270330 = phi double [ %.13.i270326, %B1614.endif.endif.endif.endif.endif.endif.thread ], [ %.13.i270, %B1614.endif.endif.endif.endif.endif.endif ]
  %at.2.0.lcssa.i329 = phi i64 [ %at.2.0.lcssa.i.ph, %B1614.endif.endif.endif.endif.endif.endif.thread ], [ %at.2.0.lcssa.i.fr, %B1614.endif.endif.endif.endif.endif.endif ]
  %90 = phi i64 [ 0, %B1614.endif.endif.endif.endif.endif.endif.thread ], [ %spec.select, %B1614.endif.endif.endif.endif.endif.endif ]
  %.4237 = add i64 %90, %at.2.0.lcssa.i329
  %.4250 = getelementptr double, ptr %.520, i64 %.4237
  %.4251 = load double, ptr %.4250, align 8
  %.4280 = getelementptr double, ptr %.660, i64 %.4237
  %.4281 = load double, ptr %.4280, align 8
  %.4282 = fmul double %.13.i268, %.4281
  %.4283 = fadd double %.4251, %.4282
  %.12.i271 = fcmp olt double %.4283, %.13.i270330
  %.13.i272 = select i1 %.12.i271, double %.4283, double %.13.i270330
  %.4341 = getelementptr double, ptr %.1231, i64 %.2766
  store double %.13.i272, ptr %.4341, align 8
  %.4372 = getelementptr double, ptr %.1161, i64 %.2766
  store double 0.000000e+00, ptr %.4372, align 8
  %sunkaddr482 = shl i64 %.2698, 3
  %sunkaddr483 = getelementptr i8, ptr %.1161, i64 %sunkaddr482
  %.4405 = load double, ptr %sunkaddr483, align 8
  %.4407 = fcmp ogt double %.4405, 0.000000e+00
  br i1 %.4407, label %B2118.endif.endif, label %B1614.endif.endif.endif.endif.endif.endif.endif.B2392_crit_edge

B1614.endif.endif.endif.endif.endif.endif.endif.B2392_crit_edge: ; preds = %B1614.endif.endif.endif.endif.endif.endif.endif
  %sunkaddr484 = shl i64 %.2766, 3
  %sunkaddr485 = getelementptr i8, ptr %.1231, i64 %sunkaddr484
  %.4799.pre = load double, ptr %sunkaddr485, align 8
  br label %B2392.endif

B2118.endif.endif:                                ; preds = %B1614.endif.endif.endif.endif.endif.endif.endif
  %sunkaddr487 = getelementptr i8, ptr %.1231, i64 %sunkaddr482
  %.4440 = load double, ptr %sunkaddr487, align 8
  %.4441 = fneg double %.4440
  %.12.i240 = fcmp olt double %y.2.0.sink.i, %.4441
  %.13.i241 = select i1 %.12.i240, double %.4441, double %y.2.0.sink.i
  %.4505 = fneg double %.4405
  %.12.i273 = fcmp ogt double %.13.i241, %.4505
  %.13.i274 = select i1 %.12.i273, double %.4505, double %.13.i241
  br i1 %15, label %B2118.endif.endif.endif.endif, label %B90.preheader.i276

B90.preheader.i276:                               ; preds = %B2118.endif.endif
  br i1 %17, label %B90.epil.preheader.i305, label %B90.i279

B90.i279:                                         ; preds = %B90.preheader.i276, %B90.i279
  %least.2.0108.i280 = phi double [ %least.3.1.1.i301, %B90.i279 ], [ 0x7FF0000000000000, %B90.preheader.i276 ]
  %at.2.0107.i281 = phi i64 [ %at.3.1.1.i300, %B90.i279 ], [ 0, %B90.preheader.i276 ]
  %.138103105.i282 = phi i64 [ %92, %B90.i279 ], [ 0, %B90.preheader.i276 ]
  %sunkaddr.i283 = shl i64 %.138103105.i282, 3
  %scevgep433 = getelementptr i8, ptr %scevgep425, i64 %sunkaddr.i283
  %scevgep434 = getelementptr i8, ptr %scevgep433, i64 -8
  %.213.i285 = load double, ptr %scevgep434, align 8, !noalias !36
  %scevgep430 = getelementptr i8, ptr %scevgep421, i64 %sunkaddr.i283
  %scevgep431 = getelementptr i8, ptr %scevgep430, i64 -8
  %.244.i287 = load double, ptr %scevgep431, align 8, !noalias !36
  %.246.i288 = fmul double %.13.i274, %.244.i287
  %.247.i289 = fadd double %.213.i285, %.246.i288
  %.253.i290 = fcmp olt double %.247.i289, %least.2.0108.i280
  %at.3.1.i291 = select i1 %.253.i290, i64 %.138103105.i282, i64 %at.2.0107.i281
  %least.3.1.i292 = select i1 %.253.i290, double %.247.i289, double %least.2.0108.i280
  %.213.1.i294 = load double, ptr %scevgep433, align 8, !noalias !36
  %.244.1.i296 = load double, ptr %scevgep430, align 8, !noalias !36
  %.246.1.i297 = fmul double %.13.i274, %.244.1.i296
  %.247.1.i298 = fadd double %.213.1.i294, %.246.1.i297
  %.253.1.i299 = fcmp olt double %.247.1.i298, %least.3.1.i292
  %91 = or disjoint i64 %.138103105.i282, 1
  %at.3.1.1.i300 = select i1 %.253.1.i299, i64 %91, i64 %at.3.1.i291
  %least.3.1.1.i301 = select i1 %.253.1.i299, double %.247.1.i298, double %least.3.1.i292
  %92 = add i64 %.138103105.i282, 2
  %niter.ncmp.1.i302 = icmp eq i64 %92, %unroll_iter.i
  br i1 %niter.ncmp.1.i302, label %B154.loopexit.unr-lcssa.i303, label %B90.i279

B154.loopexit.unr-lcssa.i303:                     ; preds = %B90.i279
  br i1 %19, label %B2118.endif.endif.endif, label %B90.epil.preheader.i305

B90.epil.preheader.i305:                          ; preds = %B154.loopexit.unr-lcssa.i303, %B90.preheader.i276
  %least.2.0108.epil.init.i306 = phi double [ 0x7FF0000000000000, %B90.preheader.i276 ], [ %least.3.1.1.i301, %B154.loopexit.unr-lcssa.i303 ]
  %at.2.0107.epil.init.i307 = phi i64 [ 0, %B90.preheader.i276 ], [ %at.3.1.1.i300, %B154.loopexit.unr-lcssa.i303 ]
  %.213.epil.i309 = load double, ptr %sunkaddr32.i, align 8, !noalias !36
  %.244.epil.i310 = load double, ptr %sunkaddr34.i, align 8, !noalias !36
  %.246.epil.i311 = fmul double %.13.i274, %.244.epil.i310
  %.247.epil.i312 = fadd double %.213.epil.i309, %.246.epil.i311
  %.253.epil.i313 = fcmp olt double %.247.epil.i312, %least.2.0108.epil.init.i306
  br i1 %.253.epil.i313, label %B2118.endif.endif.endif.endif, label %B2118.endif.endif.endif

B2118.endif.endif.endif:                          ; preds = %B90.epil.preheader.i305, %B154.loopexit.unr-lcssa.i303
  %at.2.0.lcssa.i315 = phi i64 [ %at.2.0107.epil.init.i307, %B90.epil.preheader.i305 ], [ %at.3.1.1.i300, %B154.loopexit.unr-lcssa.i303 ]
  %at.2.0.lcssa.i315.fr = freeze i64 %at.2.0.lcssa.i315
  %.4578 = icmp slt i64 %at.2.0.lcssa.i315.fr, 0
  %spec.select346 = select i1 %.4578, i64 %arg.of_rows.5.1, i64 0
  br label %B2118.endif.endif.endif.endif

B2118.endif.endif.endif.endif:                    ; preds = %B2118.endif.endif.endif, %B90.epil.preheader.i305, %B2118.endif.endif
  %at.2.0.lcssa.i315336 = phi i64 [ %unroll_iter.i, %B90.epil.preheader.i305 ], [ %at.2.0.lcssa.i315.fr, %B2118.endif.endif.endif ], [ 0, %B2118.endif.endif ]
  %93 = phi i64 [ 0, %B90.epil.preheader.i305 ], [ %spec.select346, %B2118.endif.endif.endif ], [ 0, %B2118.endif.endif ]
  %.4580 = add i64 %93, %at.2.0.lcssa.i315336
  %.4593 = getelementptr double, ptr %.520, i64 %.4580
  %.4594 = load double, ptr %.4593, align 8
  %.4595 = fneg double %.4594
  %.4624 = getelementptr double, ptr %.660, i64 %.4580
  %.4625 = load double, ptr %.4624, align 8
  %.4626 = fmul double %.13.i274, %.4625
  %.4627 = fsub double %.4595, %.4626
  %.12.i317 = fcmp olt double %.4627, 0.000000e+00
  %.13.i318 = select i1 %.12.i317, double 0.000000e+00, double %.4627
  %sunkaddr492 = shl i64 %.2766, 3
  %sunkaddr493 = getelementptr i8, ptr %.1161, i64 %sunkaddr492
  store double %.13.i318, ptr %sunkaddr493, align 8
  %sunkaddr495 = getelementptr i8, ptr %.1231, i64 %sunkaddr492
  %.4748 = load double, ptr %sunkaddr495, align 8
  %.4751 = fmul double %.4748, 0x3FF000000044B830
  %.4752 = fcmp ogt double %.13.i318, %.4751
  %.4754 = or i1 %.3874, %.4752
  br label %B2392.endif

B2392.endif:                                      ; preds = %B2118.endif.endif.endif.endif, %B1614.endif.endif.endif.endif.endif.endif.endif.B2392_crit_edge
  %sunkaddr496.pre-phi = phi i64 [ %sunkaddr492, %B2118.endif.endif.endif.endif ], [ %sunkaddr484, %B1614.endif.endif.endif.endif.endif.endif.endif.B2392_crit_edge ]
  %.4799 = phi double [ %.4748, %B2118.endif.endif.endif.endif ], [ %.4799.pre, %B1614.endif.endif.endif.endif.endif.endif.endif.B2392_crit_edge ]
  %failed.6.2 = phi i1 [ %.4754, %B2118.endif.endif.endif.endif ], [ %.3874, %B1614.endif.endif.endif.endif.endif.endif.endif.B2392_crit_edge ]
  %.12.i242 = fcmp olt double %.4799, 0.000000e+00
  %.13.i243 = select i1 %.12.i242, double 0.000000e+00, double %.4799
  %sunkaddr497 = getelementptr i8, ptr %.1231, i64 %sunkaddr496.pre-phi
  store double %.13.i243, ptr %sunkaddr497, align 8
  %.2511 = icmp sgt i64 %.251026362727, 1
  br i1 %.2511, label %B704, label %B2446

B2670.endif.endif:                                ; preds = %B2446
  %.4929 = fcmp ogt double %.4895, %.4928
  %.5105 = fmul double %.4895, 0x3FEFFFFFFF768FA1
  %.5106 = fcmp olt double %.4965, %.5105
  %94 = or i1 %.4929, %.5106
  %.5112 = or i1 %failed.5.1.lcssa, %94
  %.12.i244 = fcmp ogt double %.4895, %.4965
  %.13.i245 = select i1 %.12.i244, double %.4895, double %.4965
  %.12.i319 = fcmp olt double %.4925, %.13.i245
  %.13.i320 = select i1 %.12.i319, double %.4925, double %.13.i245
  br i1 %.5112, label %B2828.endif, label %B2800

B2828.endif:                                      ; preds = %B2670.endif.endif, %B2800, %B2670.endif.endif.thread
  %.13.i320344 = phi double [ %.13.i320, %B2800 ], [ %.13.i320, %B2670.endif.endif ], [ %.13.i320342, %B2670.endif.endif.thread ]
  %.5112343 = phi i1 [ false, %B2800 ], [ true, %B2670.endif.endif ], [ true, %B2670.endif.endif.thread ]
  %"$phi2828.1.2.1" = phi double [ %.5278, %B2800 ], [ 0x7FF8000000000000, %B2670.endif.endif ], [ 0x7FF8000000000000, %B2670.endif.endif.thread ]
  %.5338 = mul i64 %.176028013152, %arg.rates.5.1
  %.5342 = getelementptr double, ptr %arg.rates.4, i64 %.5338
  store double %"$phi2828.1.2.1", ptr %.5342, align 8
  br i1 %9, label %B2880, label %B300.loopexit

B3276.endif:                                      ; preds = %B3198
  %scevgep435 = getelementptr i8, ptr %.450, i64 %22
  %.5996 = load double, ptr %scevgep435, align 8
  %.9.i246 = fcmp ogt double %.5753, 0.000000e+00
  %95 = fneg double %.5996
  %"$phi46.2.2.0.p.i247" = select i1 %.9.i246, double %95, double %.5996
  %"$phi46.2.2.0.i248" = fadd double %"$phi46.2.2.0.p.i247", 1.000000e+00
  %.12.i.i249 = fcmp olt double %"$phi46.2.2.0.i248", 0.000000e+00
  %.13.i.i250 = select i1 %.12.i.i249, double 0.000000e+00, double %"$phi46.2.2.0.i248"
  %.6137 = fneg double %.5817
  %"$phi3400.7.2.4" = select i1 %.9.i246, double %.5817, double %.6137
  %.6143 = fmul double %x.4.12765, %"$phi3400.7.2.4"
  %.6147 = fsub double %.13.i.i250, %.6143
  %.6154 = fdiv double %.6147, %.5754
  %.12.i321 = fcmp olt double %.6154, %y.5.22741
  %.13.i322 = select i1 %.12.i321, double %.6154, double %y.5.22741
  br label %B3432

B3434.endif:                                      ; preds = %B3432, %B2880
  %y.5.2.lcssa = phi double [ %.5585, %B2880 ], [ %y.6.3, %B3432 ]
  %.6239 = getelementptr double, ptr %.1161, i64 %.5441
  %.6240 = load double, ptr %.6239, align 8
  %.12.i251 = fcmp ogt double %.6240, %y.5.2.lcssa
  %.13.i252 = select i1 %.12.i251, double %.6240, double %y.5.2.lcssa
  br i1 %.5112343, label %B3540, label %B3512
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @part.0(ptr noalias nonnull writeonly captures(none) %retptr, ptr writeonly captures(none) %arg.p.4, i64 %arg.p.5.0, ptr writeonly captures(none) %arg.r.4, ptr writeonly captures(none) %arg.g.4, ptr readonly captures(none) %arg.s.4, i64 %arg.s.5.0, i64 %arg.s.5.1, i64 %arg.s.6.0, i64 %arg.s.6.1, ptr readonly captures(none) %arg.begins.0.4, i64 %arg.begins.0.5.0, i64 %arg.begins.0.5.1, i64 %arg.begins.0.6.0, i64 %arg.begins.0.6.1, i64 %arg.begins.0.6.2, ptr readonly captures(none) %arg.begins.1.4, i64 %arg.begins.1.5.0, i64 %arg.begins.1.5.1, i64 %arg.begins.1.6.0, i64 %arg.begins.1.6.1, i64 %arg.begins.1.6.2, ptr readonly captures(none) %arg.begins.2.4, i64 %arg.begins.2.5.0, i64 %arg.begins.2.5.1, i64 %arg.begins.2.6.0, i64 %arg.begins.2.6.1, i64 %arg.begins.2.6.2, ptr readonly captures(none) %arg.ends.0.4, i64 %arg.ends.0.5.0, i64 %arg.ends.0.5.1, i64 %arg.ends.0.6.0, i64 %arg.ends.0.6.1, i64 %arg.ends.0.6.2, ptr readonly captures(none) %arg.ends.1.4, i64 %arg.ends.1.5.0, i64 %arg.ends.1.5.1, i64 %arg.ends.1.6.0, i64 %arg.ends.1.6.1, i64 %arg.ends.1.6.2, ptr readonly captures(none) %arg.ends.2.4, i64 %arg.ends.2.5.0, i64 %arg.ends.2.5.1, i64 %arg.ends.2.6.0, i64 %arg.ends.2.6.1, i64 %arg.ends.2.6.2, i64 %arg.b, i64 %arg.i) unnamed_addr #0 {
B0.else.if:
  %.231 = add nsw i64 %arg.i, 1
  %.256 = icmp slt i64 %arg.b, 0
  %.257 = select i1 %.256, i64 %arg.s.5.0, i64 0
  %.258 = add i64 %.257, %arg.b
  %.259 = icmp slt i64 %arg.i, -1
  %.260 = select i1 %.259, i64 %arg.s.5.1, i64 0
  %.261 = add i64 %.231, %.260
  %.277 = mul i64 %.258, %arg.s.6.0
  %.278 = mul i64 %.261, %arg.s.6.1
  %0 = getelementptr i8, ptr %arg.s.4, i64 %.277
  %.281 = getelementptr i8, ptr %0, i64 %.278
  %.283 = load double, ptr %.281, align 8
  %.314 = icmp slt i64 %arg.i, 0
  %.315 = select i1 %.314, i64 %arg.s.5.1, i64 0
  %.316 = add i64 %.315, %arg.i
  %.333 = mul i64 %.316, %arg.s.6.1
  %.336 = getelementptr i8, ptr %0, i64 %.333
  %.338 = load double, ptr %.336, align 8
  %.346 = fsub double %.283, %.338
  %.348 = fmul double %.346, 2.000000e+00
  %.366.1 = ashr i64 %arg.p.5.0, 1
  %.487545.not = icmp slt i64 %.366.1, 1
  br i1 %.487545.not, label %B444, label %B126.lr.ph

B126.lr.ph:                                       ; preds = %B0.else.if
  %.568 = select i1 %.256, i64 %arg.begins.0.5.0, i64 0
  %.569 = add i64 %.568, %arg.b
  %.571 = select i1 %.314, i64 %arg.begins.0.5.1, i64 0
  %.572 = add i64 %.571, %arg.i
  %.596 = mul i64 %.569, %arg.begins.0.6.0
  %.597 = mul i64 %.572, %arg.begins.0.6.1
  %1 = getelementptr i8, ptr %arg.begins.0.4, i64 %.596
  %2 = getelementptr i8, ptr %1, i64 %.597
  %.693 = select i1 %.256, i64 %arg.begins.1.5.0, i64 0
  %.694 = add i64 %.693, %arg.b
  %.696 = select i1 %.314, i64 %arg.begins.1.5.1, i64 0
  %.697 = add i64 %.696, %arg.i
  %.721 = mul i64 %.694, %arg.begins.1.6.0
  %.722 = mul i64 %.697, %arg.begins.1.6.1
  %3 = getelementptr i8, ptr %arg.begins.1.4, i64 %.721
  %4 = getelementptr i8, ptr %3, i64 %.722
  %.844 = select i1 %.256, i64 %arg.begins.2.5.0, i64 0
  %.845 = add i64 %.844, %arg.b
  %.847 = select i1 %.314, i64 %arg.begins.2.5.1, i64 0
  %.848 = add i64 %.847, %arg.i
  %.872 = mul i64 %.845, %arg.begins.2.6.0
  %.873 = mul i64 %.848, %arg.begins.2.6.1
  %5 = getelementptr i8, ptr %arg.begins.2.4, i64 %.872
  %6 = getelementptr i8, ptr %5, i64 %.873
  %.964 = select i1 %.256, i64 %arg.ends.0.5.0, i64 0
  %.965 = add i64 %.964, %arg.b
  %.967 = select i1 %.314, i64 %arg.ends.0.5.1, i64 0
  %.968 = add i64 %.967, %arg.i
  %.992 = mul i64 %.965, %arg.ends.0.6.0
  %.993 = mul i64 %.968, %arg.ends.0.6.1
  %7 = getelementptr i8, ptr %arg.ends.0.4, i64 %.992
  %8 = getelementptr i8, ptr %7, i64 %.993
  %.1092 = select i1 %.256, i64 %arg.ends.1.5.0, i64 0
  %.1093 = add i64 %.1092, %arg.b
  %.1095 = select i1 %.314, i64 %arg.ends.1.5.1, i64 0
  %.1096 = add i64 %.1095, %arg.i
  %.1120 = mul i64 %.1093, %arg.ends.1.6.0
  %.1121 = mul i64 %.1096, %arg.ends.1.6.1
  %9 = getelementptr i8, ptr %arg.ends.1.4, i64 %.1120
  %10 = getelementptr i8, ptr %9, i64 %.1121
  %.1247 = select i1 %.256, i64 %arg.ends.2.5.0, i64 0
  %.1248 = add i64 %.1247, %arg.b
  %.1250 = select i1 %.314, i64 %arg.ends.2.5.1, i64 0
  %.1251 = add i64 %.1250, %arg.i
  %.1275 = mul i64 %.1248, %arg.ends.2.6.0
  %.1276 = mul i64 %.1251, %arg.ends.2.6.1
  %11 = getelementptr i8, ptr %arg.ends.2.4, i64 %.1275
  %12 = getelementptr i8, ptr %11, i64 %.1276
  %min.iters.check = icmp samesign ult i64 %.366.1, 26
  br i1 %min.iters.check, label %B126.preheader, label %vector.scevcheck

vector.scevcheck:                                 ; preds = %B126.lr.ph
  %ident.check = icmp ne i64 %arg.begins.0.6.2, 1
  %ident.check1 = icmp ne i64 %arg.begins.1.6.2, 1
  %ident.check2 = icmp ne i64 %arg.begins.2.6.2, 1
  %ident.check3 = icmp ne i64 %arg.ends.0.6.2, 1
  %ident.check4 = icmp ne i64 %arg.ends.1.6.2, 1
  %ident.check5 = icmp ne i64 %arg.ends.2.6.2, 1
  %13 = add nsw i64 %.366.1, -1
  %14 = getelementptr i8, ptr %2, i64 %13
  %15 = icmp ult ptr %14, %2
  %16 = getelementptr i8, ptr %4, i64 %13
  %17 = icmp ult ptr %16, %4
  %18 = getelementptr i8, ptr %6, i64 %13
  %19 = icmp ult ptr %18, %6
  %20 = getelementptr i8, ptr %8, i64 %13
  %21 = icmp ult ptr %20, %8
  %22 = getelementptr i8, ptr %10, i64 %13
  %23 = icmp ult ptr %22, %10
  %24 = getelementptr i8, ptr %12, i64 %13
  %25 = icmp ult ptr %24, %12
  %26 = or i1 %ident.check, %ident.check1
  %27 = or i1 %26, %ident.check2
  %28 = or i1 %27, %ident.check3
  %29 = or i1 %28, %ident.check4
  %30 = or i1 %29, %ident.check5
  %31 = or i1 %30, %15
  %32 = or i1 %17, %31
  %33 = or i1 %19, %32
  %34 = or i1 %21, %33
  %35 = or i1 %23, %34
  %36 = or i1 %25, %35
  br i1 %36, label %B126.preheader, label %vector.memcheck

vector.memcheck:                                  ; preds = %vector.scevcheck
  %37 = shl i64 %.366.1, 3
  %scevgep = getelementptr i8, ptr %arg.p.4, i64 %37
  %38 = shl i64 %.366.1, 4
  %scevgep11 = getelementptr i8, ptr %arg.p.4, i64 %38
  %scevgep12 = getelementptr i8, ptr %arg.r.4, i64 %37
  %scevgep13 = getelementptr i8, ptr %arg.r.4, i64 %38
  %scevgep14 = getelementptr i8, ptr %arg.g.4, i64 %37
  %scevgep15 = getelementptr i8, ptr %arg.g.4, i64 %38
  %39 = getelementptr i8, ptr %arg.begins.0.4, i64 %.366.1
  %40 = getelementptr i8, ptr %39, i64 %.597
  %41 = getelementptr i8, ptr %40, i64 %.596
  %scevgep16 = getelementptr i8, ptr %41, i64 7
  %42 = getelementptr i8, ptr %arg.begins.1.4, i64 %.366.1
  %43 = getelementptr i8, ptr %42, i64 %.722
  %44 = getelementptr i8, ptr %43, i64 %.721
  %scevgep17 = getelementptr i8, ptr %44, i64 7
  %45 = getelementptr i8, ptr %arg.begins.2.4, i64 %.366.1
  %46 = getelementptr i8, ptr %45, i64 %.873
  %47 = getelementptr i8, ptr %46, i64 %.872
  %scevgep18 = getelementptr i8, ptr %47, i64 7
  %48 = getelementptr i8, ptr %arg.ends.0.4, i64 %.366.1
  %49 = getelementptr i8, ptr %48, i64 %.993
  %50 = getelementptr i8, ptr %49, i64 %.992
  %scevgep19 = getelementptr i8, ptr %50, i64 7
  %51 = getelementptr i8, ptr %arg.ends.1.4, i64 %.366.1
  %52 = getelementptr i8, ptr %51, i64 %.1121
  %53 = getelementptr i8, ptr %52, i64 %.1120
  %scevgep20 = getelementptr i8, ptr %53, i64 7
  %54 = getelementptr i8, ptr %arg.ends.2.4, i64 %.366.1
  %55 = getelementptr i8, ptr %54, i64 %.1276
  %56 = getelementptr i8, ptr %55, i64 %.1275
  %scevgep21 = getelementptr i8, ptr %56, i64 7
  %bound0 = icmp ult ptr %scevgep, %scevgep13
  %bound1 = icmp ult ptr %scevgep12, %scevgep11
  %found.conflict = and i1 %bound0, %bound1
  %bound022 = icmp ult ptr %scevgep, %scevgep12
  %bound123 = icmp ult ptr %arg.r.4, %scevgep11
  %found.conflict24 = and i1 %bound123, %bound022
  %conflict.rdx = or i1 %found.conflict, %found.conflict24
  %bound025 = icmp ult ptr %scevgep, %scevgep15
  %bound126 = icmp ult ptr %scevgep14, %scevgep11
  %found.conflict27 = and i1 %bound025, %bound126
  %conflict.rdx28 = or i1 %conflict.rdx, %found.conflict27
  %bound029 = icmp ult ptr %scevgep, %scevgep14
  %bound130 = icmp ult ptr %arg.g.4, %scevgep11
  %found.conflict31 = and i1 %bound130, %bound029
  %conflict.rdx32 = or i1 %found.conflict31, %conflict.rdx28
  %bound033 = icmp ult ptr %scevgep, %scevgep16
  %bound134 = icmp ult ptr %2, %scevgep11
  %found.conflict35 = and i1 %bound134, %bound033
  %conflict.rdx36 = or i1 %conflict.rdx32, %found.conflict35
  %bound037 = icmp ult ptr %scevgep, %scevgep17
  %bound138 = icmp ult ptr %4, %scevgep11
  %found.conflict39 = and i1 %bound138, %bound037
  %conflict.rdx40 = or i1 %found.conflict39, %conflict.rdx36
  %bound041 = icmp ult ptr %scevgep, %scevgep18
  %bound142 = icmp ult ptr %6, %scevgep11
  %found.conflict43 = and i1 %bound142, %bound041
  %conflict.rdx44 = or i1 %found.conflict43, %conflict.rdx40
  %bound045 = icmp ult ptr %scevgep, %scevgep19
  %bound146 = icmp ult ptr %8, %scevgep11
  %found.conflict47 = and i1 %bound146, %bound045
  %conflict.rdx48 = or i1 %found.conflict47, %conflict.rdx44
  %bound049 = icmp ult ptr %scevgep, %scevgep20
  %bound150 = icmp ult ptr %10, %scevgep11
  %found.conflict51 = and i1 %bound150, %bound049
  %conflict.rdx52 = or i1 %found.conflict51, %conflict.rdx48
  %bound053 = icmp ult ptr %scevgep, %scevgep21
  %bound154 = icmp ult ptr %12, %scevgep11
  %found.conflict55 = and i1 %bound154, %bound053
  %conflict.rdx56 = or i1 %found.conflict55, %conflict.rdx52
  %bound057 = icmp ult ptr %arg.p.4, %scevgep13
  %bound158 = icmp ult ptr %scevgep12, %scevgep
  %found.conflict59 = and i1 %bound057, %bound158
  %conflict.rdx60 = or i1 %found.conflict59, %conflict.rdx56
  %bound061 = icmp ult ptr %arg.p.4, %scevgep12
  %bound162 = icmp ult ptr %arg.r.4, %scevgep
  %found.conflict63 = and i1 %bound162, %bound061
  %conflict.rdx64 = or i1 %found.conflict63, %conflict.rdx60
  %bound065 = icmp ult ptr %arg.p.4, %scevgep15
  %bound166 = icmp ult ptr %scevgep14, %scevgep
  %found.conflict67 = and i1 %bound065, %bound166
  %conflict.rdx68 = or i1 %found.conflict67, %conflict.rdx64
  %bound069 = icmp ult ptr %arg.p.4, %scevgep14
  %bound170 = icmp ult ptr %arg.g.4, %scevgep
  %found.conflict71 = and i1 %bound170, %bound069
  %conflict.rdx72 = or i1 %found.conflict71, %conflict.rdx68
  %bound073 = icmp ult ptr %arg.p.4, %scevgep16
  %bound174 = icmp ult ptr %2, %scevgep
  %found.conflict75 = and i1 %bound174, %bound073
  %conflict.rdx76 = or i1 %found.conflict75, %conflict.rdx72
  %bound077 = icmp ult ptr %arg.p.4, %scevgep17
  %bound178 = icmp ult ptr %4, %scevgep
  %found.conflict79 = and i1 %bound178, %bound077
  %conflict.rdx80 = or i1 %found.conflict79, %conflict.rdx76
  %bound081 = icmp ult ptr %arg.p.4, %scevgep18
  %bound182 = icmp ult ptr %6, %scevgep
  %found.conflict83 = and i1 %bound182, %bound081
  %conflict.rdx84 = or i1 %found.conflict83, %conflict.rdx80
  %bound085 = icmp ult ptr %arg.p.4, %scevgep19
  %bound186 = icmp ult ptr %8, %scevgep
  %found.conflict87 = and i1 %bound186, %bound085
  %conflict.rdx88 = or i1 %found.conflict87, %conflict.rdx84
  %bound089 = icmp ult ptr %arg.p.4, %scevgep20
  %bound190 = icmp ult ptr %10, %scevgep
  %found.conflict91 = and i1 %bound190, %bound089
  %conflict.rdx92 = or i1 %found.conflict91, %conflict.rdx88
  %bound093 = icmp ult ptr %arg.p.4, %scevgep21
  %bound194 = icmp ult ptr %12, %scevgep
  %found.conflict95 = and i1 %bound194, %bound093
  %conflict.rdx96 = or i1 %found.conflict95, %conflict.rdx92
  %bound097 = icmp ult ptr %scevgep12, %scevgep15
  %bound198 = icmp ult ptr %scevgep14, %scevgep13
  %found.conflict99 = and i1 %bound097, %bound198
  %conflict.rdx100 = or i1 %found.conflict99, %conflict.rdx96
  %bound0101 = icmp ult ptr %scevgep12, %scevgep14
  %bound1102 = icmp ult ptr %arg.g.4, %scevgep13
  %found.conflict103 = and i1 %bound1102, %bound0101
  %conflict.rdx104 = or i1 %found.conflict103, %conflict.rdx100
  %bound0105 = icmp ult ptr %scevgep12, %scevgep16
  %bound1106 = icmp ult ptr %2, %scevgep13
  %found.conflict107 = and i1 %bound1106, %bound0105
  %conflict.rdx108 = or i1 %found.conflict107, %conflict.rdx104
  %bound0109 = icmp ult ptr %scevgep12, %scevgep17
  %bound1110 = icmp ult ptr %4, %scevgep13
  %found.conflict111 = and i1 %bound1110, %bound0109
  %conflict.rdx112 = or i1 %found.conflict111, %conflict.rdx108
  %bound0113 = icmp ult ptr %scevgep12, %scevgep18
  %bound1114 = icmp ult ptr %6, %scevgep13
  %found.conflict115 = and i1 %bound1114, %bound0113
  %conflict.rdx116 = or i1 %found.conflict115, %conflict.rdx112
  %bound0117 = icmp ult ptr %scevgep12, %scevgep19
  %bound1118 = icmp ult ptr %8, %scevgep13
  %found.conflict119 = and i1 %bound1118, %bound0117
  %conflict.rdx120 = or i1 %found.conflict119, %conflict.rdx116
  %bound0121 = icmp ult ptr %scevgep12, %scevgep20
  %bound1122 = icmp ult ptr %10, %scevgep13
  %found.conflict123 = and i1 %bound1122, %bound0121
  %conflict.rdx124 = or i1 %found.conflict123, %conflict.rdx120
  %bound0125 = icmp ult ptr %scevgep12, %scevgep21
  %bound1126 = icmp ult ptr %12, %scevgep13
  %found.conflict127 = and i1 %bound1126, %bound0125
  %conflict.rdx128 = or i1 %found.conflict127, %conflict.rdx124
  %bound0129 = icmp ult ptr %arg.r.4, %scevgep15
  %bound1130 = icmp ult ptr %scevgep14, %scevgep12
  %found.conflict131 = and i1 %bound0129, %bound1130
  %conflict.rdx132 = or i1 %found.conflict131, %conflict.rdx128
  %bound0133 = icmp ult ptr %arg.r.4, %scevgep14
  %bound1134 = icmp ult ptr %arg.g.4, %scevgep12
  %found.conflict135 = and i1 %bound1134, %bound0133
  %conflict.rdx136 = or i1 %found.conflict135, %conflict.rdx132
  %bound0137 = icmp ult ptr %arg.r.4, %scevgep16
  %bound1138 = icmp ult ptr %2, %scevgep12
  %found.conflict139 = and i1 %bound1138, %bound0137
  %conflict.rdx140 = or i1 %found.conflict139, %conflict.rdx136
  %bound0141 = icmp ult ptr %arg.r.4, %scevgep17
  %bound1142 = icmp ult ptr %4, %scevgep12
  %found.conflict143 = and i1 %bound1142, %bound0141
  %conflict.rdx144 = or i1 %found.conflict143, %conflict.rdx140
  %bound0145 = icmp ult ptr %arg.r.4, %scevgep18
  %bound1146 = icmp ult ptr %6, %scevgep12
  %found.conflict147 = and i1 %bound1146, %bound0145
  %conflict.rdx148 = or i1 %found.conflict147, %conflict.rdx144
  %bound0149 = icmp ult ptr %arg.r.4, %scevgep19
  %bound1150 = icmp ult ptr %8, %scevgep12
  %found.conflict151 = and i1 %bound1150, %bound0149
  %conflict.rdx152 = or i1 %found.conflict151, %conflict.rdx148
  %bound0153 = icmp ult ptr %arg.r.4, %scevgep20
  %bound1154 = icmp ult ptr %10, %scevgep12
  %found.conflict155 = and i1 %bound1154, %bound0153
  %conflict.rdx156 = or i1 %found.conflict155, %conflict.rdx152
  %bound0157 = icmp ult ptr %arg.r.4, %scevgep21
  %bound1158 = icmp ult ptr %12, %scevgep12
  %found.conflict159 = and i1 %bound1158, %bound0157
  %conflict.rdx160 = or i1 %found.conflict159, %conflict.rdx156
  %bound0161 = icmp ult ptr %scevgep14, %scevgep16
  %bound1162 = icmp ult ptr %2, %scevgep15
  %found.conflict163 = and i1 %bound1162, %bound0161
  %conflict.rdx164 = or i1 %found.conflict163, %conflict.rdx160
  %bound0165 = icmp ult ptr %scevgep14, %scevgep17
  %bound1166 = icmp ult ptr %4, %scevgep15
  %found.conflict167 = and i1 %bound1166, %bound0165
  %conflict.rdx168 = or i1 %found.conflict167, %conflict.rdx164
  %bound0169 = icmp ult ptr %scevgep14, %scevgep18
  %bound1170 = icmp ult ptr %6, %scevgep15
  %found.conflict171 = and i1 %bound1170, %bound0169
  %conflict.rdx172 = or i1 %found.conflict171, %conflict.rdx168
  %bound0173 = icmp ult ptr %scevgep14, %scevgep19
  %bound1174 = icmp ult ptr %8, %scevgep15
  %found.conflict175 = and i1 %bound1174, %bound0173
  %conflict.rdx176 = or i1 %found.conflict175, %conflict.rdx172
  %bound0177 = icmp ult ptr %scevgep14, %scevgep20
  %bound1178 = icmp ult ptr %10, %scevgep15
  %found.conflict179 = and i1 %bound1178, %bound0177
  %conflict.rdx180 = or i1 %found.conflict179, %conflict.rdx176
  %bound0181 = icmp ult ptr %scevgep14, %scevgep21
  %bound1182 = icmp ult ptr %12, %scevgep15
  %found.conflict183 = and i1 %bound1182, %bound0181
  %conflict.rdx184 = or i1 %found.conflict183, %conflict.rdx180
  %bound0185 = icmp ult ptr %arg.g.4, %scevgep16
  %bound1186 = icmp ult ptr %2, %scevgep14
  %found.conflict187 = and i1 %bound1186, %bound0185
  %conflict.rdx188 = or i1 %found.conflict187, %conflict.rdx184
  %bound0189 = icmp ult ptr %arg.g.4, %scevgep17
  %bound1190 = icmp ult ptr %4, %scevgep14
  %found.conflict191 = and i1 %bound1190, %bound0189
  %conflict.rdx192 = or i1 %found.conflict191, %conflict.rdx188
  %bound0193 = icmp ult ptr %arg.g.4, %scevgep18
  %bound1194 = icmp ult ptr %6, %scevgep14
  %found.conflict195 = and i1 %bound1194, %bound0193
  %conflict.rdx196 = or i1 %found.conflict195, %conflict.rdx192
  %bound0197 = icmp ult ptr %arg.g.4, %scevgep19
  %bound1198 = icmp ult ptr %8, %scevgep14
  %found.conflict199 = and i1 %bound1198, %bound0197
  %conflict.rdx200 = or i1 %found.conflict199, %conflict.rdx196
  %bound0201 = icmp ult ptr %arg.g.4, %scevgep20
  %bound1202 = icmp ult ptr %10, %scevgep14
  %found.conflict203 = and i1 %bound1202, %bound0201
  %conflict.rdx204 = or i1 %found.conflict203, %conflict.rdx200
  %bound0205 = icmp ult ptr %arg.g.4, %scevgep21
  %bound1206 = icmp ult ptr %12, %scevgep14
  %found.conflict207 = and i1 %bound1206, %bound0205
  %conflict.rdx208 = or i1 %found.conflict207, %conflict.rdx204
  br i1 %conflict.rdx208, label %B126.preheader, label %vector.ph

vector.ph:                                        ; preds = %vector.memcheck
  %n.vec = and i64 %.366.1, 9223372036854775806
  %broadcast.splatinsert = insertelement <2 x double> poison, double %.348, i64 0
  %broadcast.splat = shufflevector <2 x double> %broadcast.splatinsert, <2 x double> poison, <2 x i32> zeroinitializer
  %57 = getelementptr i8, ptr %arg.begins.0.4, i64 %.597
  %58 = getelementptr i8, ptr %57, i64 %.596
  %scevgep239 = getelementptr i8, ptr %58, i64 1
  %59 = getelementptr i8, ptr %arg.begins.1.4, i64 %.722
  %60 = getelementptr i8, ptr %59, i64 %.721
  %scevgep243 = getelementptr i8, ptr %60, i64 1
  %61 = getelementptr i8, ptr %arg.begins.2.4, i64 %.873
  %62 = getelementptr i8, ptr %61, i64 %.872
  %scevgep247 = getelementptr i8, ptr %62, i64 1
  %63 = getelementptr i8, ptr %arg.ends.0.4, i64 %.993
  %64 = getelementptr i8, ptr %63, i64 %.992
  %scevgep251 = getelementptr i8, ptr %64, i64 1
  %65 = getelementptr i8, ptr %arg.ends.1.4, i64 %.1121
  %66 = getelementptr i8, ptr %65, i64 %.1120
  %scevgep255 = getelementptr i8, ptr %66, i64 1
  %67 = getelementptr i8, ptr %arg.ends.2.4, i64 %.1276
  %68 = getelementptr i8, ptr %67, i64 %.1275
  %scevgep259 = getelementptr i8, ptr %68, i64 1
  br label %vector.body

vector.body:                                      ; preds = %vector.body, %vector.ph
  %index = phi i64 [ 0, %vector.ph ], [ %index.next, %vector.body ]
  %scevgep241 = getelementptr i8, ptr %scevgep239, i64 %index
  %scevgep242 = getelementptr i8, ptr %scevgep241, i64 -1
  %69 = load double, ptr %scevgep242, align 8, !alias.scope !39
  %70 = load double, ptr %scevgep241, align 8, !alias.scope !39
  %71 = insertelement <2 x double> poison, double %69, i64 0
  %72 = insertelement <2 x double> %71, double %70, i64 1
  %73 = fdiv <2 x double> %72, %broadcast.splat
  %74 = shl i64 %index, 3
  %scevgep263 = getelementptr i8, ptr %arg.p.4, i64 %74
  store <2 x double> %73, ptr %scevgep263, align 8, !alias.scope !42, !noalias !44
  %scevgep245 = getelementptr i8, ptr %scevgep243, i64 %index
  %scevgep246 = getelementptr i8, ptr %scevgep245, i64 -1
  %75 = load double, ptr %scevgep246, align 8, !alias.scope !54
  %76 = load double, ptr %scevgep245, align 8, !alias.scope !54
  %77 = insertelement <2 x double> poison, double %75, i64 0
  %78 = insertelement <2 x double> %77, double %76, i64 1
  %79 = fsub <2 x double> %78, %73
  %scevgep23 = getelementptr i8, ptr %arg.r.4, i64 %74
  store <2 x double> %79, ptr %scevgep23, align 8, !alias.scope !55, !noalias !56
  %scevgep249 = getelementptr i8, ptr %scevgep247, i64 %index
  %scevgep250 = getelementptr i8, ptr %scevgep249, i64 -1
  %80 = load double, ptr %scevgep250, align 8, !alias.scope !57
  %81 = load double, ptr %scevgep249, align 8, !alias.scope !57
  %82 = insertelement <2 x double> poison, double %80, i64 0
  %83 = insertelement <2 x double> %82, double %81, i64 1
  %scevgep22 = getelementptr i8, ptr %arg.g.4, i64 %74
  store <2 x double> %83, ptr %scevgep22, align 8, !alias.scope !58, !noalias !59
  %scevgep253 = getelementptr i8, ptr %scevgep251, i64 %index
  %scevgep254 = getelementptr i8, ptr %scevgep253, i64 -1
  %84 = load double, ptr %scevgep254, align 8, !alias.scope !60
  %85 = load double, ptr %scevgep253, align 8, !alias.scope !60
  %86 = insertelement <2 x double> poison, double %84, i64 0
  %87 = insertelement <2 x double> %86, double %85, i64 1
  %88 = fneg <2 x double> %87
  %89 = fdiv <2 x double> %88, %broadcast.splat
  %scevgep10 = getelementptr i8, ptr %scevgep12, i64 %74
  store <2 x double> %89, ptr %scevgep10, align 8, !alias.scope !61, !noalias !56
  %scevgep257 = getelementptr i8, ptr %scevgep255, i64 %index
  %scevgep258 = getelementptr i8, ptr %scevgep257, i64 -1
  %90 = load double, ptr %scevgep258, align 8, !alias.scope !62
  %91 = load double, ptr %scevgep257, align 8, !alias.scope !62
  %92 = insertelement <2 x double> poison, double %90, i64 0
  %93 = insertelement <2 x double> %92, double %91, i64 1
  %94 = fsub <2 x double> %93, %89
  %scevgep9 = getelementptr i8, ptr %scevgep, i64 %74
  store <2 x double> %94, ptr %scevgep9, align 8, !alias.scope !63, !noalias !44
  %scevgep261 = getelementptr i8, ptr %scevgep259, i64 %index
  %scevgep262 = getelementptr i8, ptr %scevgep261, i64 -1
  %95 = load double, ptr %scevgep262, align 8, !alias.scope !65
  %96 = load double, ptr %scevgep261, align 8, !alias.scope !65
  %97 = insertelement <2 x double> poison, double %95, i64 0
  %98 = insertelement <2 x double> %97, double %96, i64 1
  %scevgep8 = getelementptr i8, ptr %scevgep14, i64 %74
  store <2 x double> %98, ptr %scevgep8, align 8, !alias.scope !66, !noalias !59
  %index.next = add nuw nsw i64 %index, 2
  %99 = icmp eq i64 %n.vec, %index.next
  br i1 %99, label %middle.block, label %vector.body, !llvm.loop !67

middle.block:                                     ; preds = %vector.body
  %cmp.n = icmp eq i64 %.366.1, %n.vec
  br i1 %cmp.n, label %B444, label %B126.preheader

B126.preheader:                                   ; preds = %middle.block, %vector.memcheck, %vector.scevcheck, %B126.lr.ph
  %.493544546.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %vector.scevcheck ], [ 0, %B126.lr.ph ], [ %n.vec, %middle.block ]
  %100 = mul i64 %.493544546.ph, %arg.ends.2.6.2
  %101 = getelementptr i8, ptr %arg.ends.2.4, i64 %100
  %102 = getelementptr i8, ptr %101, i64 %.1276
  %scevgep209 = getelementptr i8, ptr %102, i64 %.1275
  %103 = mul i64 %.493544546.ph, %arg.ends.1.6.2
  %104 = getelementptr i8, ptr %arg.ends.1.4, i64 %103
  %105 = getelementptr i8, ptr %104, i64 %.1121
  %scevgep211 = getelementptr i8, ptr %105, i64 %.1120
  %106 = mul i64 %.493544546.ph, %arg.ends.0.6.2
  %107 = getelementptr i8, ptr %arg.ends.0.4, i64 %106
  %108 = getelementptr i8, ptr %107, i64 %.993
  %scevgep214 = getelementptr i8, ptr %108, i64 %.992
  %109 = mul i64 %.493544546.ph, %arg.begins.2.6.2
  %110 = getelementptr i8, ptr %arg.begins.2.4, i64 %109
  %111 = getelementptr i8, ptr %110, i64 %.873
  %scevgep217 = getelementptr i8, ptr %111, i64 %.872
  %112 = mul i64 %.493544546.ph, %arg.begins.1.6.2
  %113 = getelementptr i8, ptr %arg.begins.1.4, i64 %112
  %114 = getelementptr i8, ptr %113, i64 %.722
  %scevgep220 = getelementptr i8, ptr %114, i64 %.721
  %115 = mul i64 %.493544546.ph, %arg.begins.0.6.2
  %116 = getelementptr i8, ptr %arg.begins.0.4, i64 %115
  %117 = getelementptr i8, ptr %116, i64 %.597
  %scevgep223 = getelementptr i8, ptr %117, i64 %.596
  %118 = shl i64 %.493544546.ph, 3
  %scevgep226 = getelementptr i8, ptr %arg.g.4, i64 %118
  %scevgep229 = getelementptr i8, ptr %arg.r.4, i64 %118
  %scevgep231 = getelementptr i8, ptr %arg.p.4, i64 %118
  %119 = add nuw nsw i64 %.493544546.ph, %.366.1
  %120 = shl i64 %119, 3
  %scevgep233 = getelementptr i8, ptr %arg.g.4, i64 %120
  %scevgep235 = getelementptr i8, ptr %arg.p.4, i64 %120
  %scevgep237 = getelementptr i8, ptr %arg.r.4, i64 %120
  %121 = sub nsw i64 %.366.1, %.493544546.ph
  br label %B126

B126:                                             ; preds = %B126, %B126.preheader
  %lsr.iv227 = phi i64 [ 0, %B126.preheader ], [ %lsr.iv.next, %B126 ]
  %lsr.iv224 = phi ptr [ %scevgep223, %B126.preheader ], [ %scevgep225, %B126 ]
  %lsr.iv221 = phi ptr [ %scevgep220, %B126.preheader ], [ %scevgep222, %B126 ]
  %lsr.iv218 = phi ptr [ %scevgep217, %B126.preheader ], [ %scevgep219, %B126 ]
  %lsr.iv215 = phi ptr [ %scevgep214, %B126.preheader ], [ %scevgep216, %B126 ]
  %lsr.iv212 = phi ptr [ %scevgep211, %B126.preheader ], [ %scevgep213, %B126 ]
  %lsr.iv = phi ptr [ %scevgep209, %B126.preheader ], [ %scevgep210, %B126 ]
  %.604 = load double, ptr %lsr.iv224, align 8
  %.619 = fdiv double %.604, %.348
  %122 = shl i64 %lsr.iv227, 3
  %scevgep232 = getelementptr i8, ptr %scevgep231, i64 %122
  store double %.619, ptr %scevgep232, align 8
  %.729 = load double, ptr %lsr.iv221, align 8
  %.770 = fsub double %.729, %.619
  %scevgep230 = getelementptr i8, ptr %scevgep229, i64 %122
  store double %.770, ptr %scevgep230, align 8
  %.880 = load double, ptr %lsr.iv218, align 8
  %scevgep7 = getelementptr i8, ptr %scevgep226, i64 %122
  store double %.880, ptr %scevgep7, align 8
  %.1000 = load double, ptr %lsr.iv215, align 8
  %.1011 = fneg double %.1000
  %.1016 = fdiv double %.1011, %.348
  %scevgep6 = getelementptr i8, ptr %scevgep237, i64 %122
  store double %.1016, ptr %scevgep6, align 8
  %.1128 = load double, ptr %lsr.iv212, align 8
  %.1171 = fsub double %.1128, %.1016
  %scevgep5 = getelementptr i8, ptr %scevgep235, i64 %122
  store double %.1171, ptr %scevgep5, align 8
  %.1283 = load double, ptr %lsr.iv, align 8
  %scevgep4 = getelementptr i8, ptr %scevgep233, i64 %122
  store double %.1283, ptr %scevgep4, align 8
  %scevgep210 = getelementptr i8, ptr %lsr.iv, i64 %arg.ends.2.6.2
  %scevgep213 = getelementptr i8, ptr %lsr.iv212, i64 %arg.ends.1.6.2
  %scevgep216 = getelementptr i8, ptr %lsr.iv215, i64 %arg.ends.0.6.2
  %scevgep219 = getelementptr i8, ptr %lsr.iv218, i64 %arg.begins.2.6.2
  %scevgep222 = getelementptr i8, ptr %lsr.iv221, i64 %arg.begins.1.6.2
  %scevgep225 = getelementptr i8, ptr %lsr.iv224, i64 %arg.begins.0.6.2
  %lsr.iv.next = add i64 %lsr.iv227, 1
  %exitcond.not = icmp eq i64 %121, %lsr.iv.next
  br i1 %exitcond.not, label %B444, label %B126, !llvm.loop !68

B444:                                             ; preds = %B126, %middle.block, %B0.else.if
  store ptr null, ptr %retptr, align 8
  ret void
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #1

; Function Attrs: mustprogress nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #2

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #1 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #2 = { mustprogress nofree nosync nounwind willreturn memory(none) }

!0 = !{!1}
!1 = distinct !{!1, !2}
!2 = distinct !{!2, !"LVerDomain"}
!3 = !{!4}
!4 = distinct !{!4, !2}
!5 = distinct !{!5, !6, !7}
!6 = !{!"llvm.loop.isvectorized", i32 1}
!7 = !{!"llvm.loop.unroll.runtime.disable"}
!8 = distinct !{!8, !6}
!9 = !{!10}
!10 = distinct !{!10, !11, !"part.3: %retptr"}
!11 = distinct !{!11, !"part.3"}
!12 = !{!13}
!13 = distinct !{!13, !14, !"part.4: %retptr"}
!14 = distinct !{!14, !"part.4"}
!15 = !{!16, !13}
!16 = distinct !{!16, !17, !"part.5: %retptr"}
!17 = distinct !{!17, !"part.5"}
!18 = !{!19, !13}
!19 = distinct !{!19, !20, !"part.5: %retptr"}
!20 = distinct !{!20, !"part.5"}
!21 = !{!22, !24}
!22 = distinct !{!22, !23, !"part.5: %retptr"}
!23 = distinct !{!23, !"part.5"}
!24 = distinct !{!24, !25, !"part.6: %retptr"}
!25 = distinct !{!25, !"part.6"}
!26 = !{!24}
!27 = !{!28, !24}
!28 = distinct !{!28, !29, !"part.5: %retptr"}
!29 = distinct !{!29, !"part.5"}
!30 = !{!31, !24}
!31 = distinct !{!31, !32, !"part.5: %retptr"}
!32 = distinct !{!32, !"part.5"}
!33 = !{!34}
!34 = distinct !{!34, !35, !"part.5: %retptr"}
!35 = distinct !{!35, !"part.5"}
!36 = !{!37}
!37 = distinct !{!37, !38, !"part.5: %retptr"}
!38 = distinct !{!38, !"part.5"}
!39 = !{!40}
!40 = distinct !{!40, !41}
!41 = distinct !{!41, !"LVerDomain"}
!42 = !{!43}
!43 = distinct !{!43, !41}
!44 = !{!45, !46, !47, !48, !40, !49, !50, !51, !52, !53}
!45 = distinct !{!45, !41}
!46 = distinct !{!46, !41}
!47 = distinct !{!47, !41}
!48 = distinct !{!48, !41}
!49 = distinct !{!49, !41}
!50 = distinct !{!50, !41}
!51 = distinct !{!51, !41}
!52 = distinct !{!52, !41}
!53 = distinct !{!53, !41}
!54 = !{!49}
!55 = !{!46}
!56 = !{!47, !48, !40, !49, !50, !51, !52, !53}
!57 = !{!50}
!58 = !{!48}
!59 = !{!40, !49, !50, !51, !52, !53}
!60 = !{!51}
!61 = !{!45}
!62 = !{!52}
!63 = !{!64}
!64 = distinct !{!64, !41}
!65 = !{!53}
!66 = !{!47}
!67 = distinct !{!67, !6, !7}
!68 = distinct !{!68, !6}
