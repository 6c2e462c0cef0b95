; sha256 0efce13db8e8fe50332a6b966a0a8d492b836acd99e2f725f34c7b81a2742bd8 of interior_point_loops.py and of this
; made by numba 0.68.1, llvmlite 0.50.0, Python 3.11.7
; loops.condense: array(float64, 1d, C); array(uint64, 1d, C); array(float64, 1d, C); array(int64, 1d, C); array(int64, 1d, C); array(uint64, 1d, C); array(float64, 1d, C); array(float64, 1d, C)
; loops.factorise: array(float64, 1d, C); array(int64, 1d, C); array(uint64, 1d, C); array(int64, 1d, C); array(uint64, 1d, C); array(int64, 1d, C); array(uint64, 1d, C); array(int64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C)
; loops.substitute: array(int64, 1d, C); array(uint64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C)
; loops.subtract_product: array(float64, 1d, C); array(int64, 1d, C); array(uint64, 1d, C); array(float64, 1d, C); array(float64, 1d, C)
; loops.add_transposed: array(float64, 1d, C); array(int64, 1d, C); array(uint64, 1d, C); array(float64, 1d, C); array(float64, 1d, C)
; loops.times: array(float64, 1d, C); array(int64, 1d, C); array(uint64, 1d, C); array(float64, 1d, C); array(float64, 1d, C)
; loops.measure: array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(uint64, 1d, C); array(uint64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C)
; loops.conditions: array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C)
; loops.stiffen: array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); float64; array(float64, 1d, C); array(float64, 1d, C)
; loops.steer: array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); float64; array(float64, 1d, C)
; loops.follow: array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); array(float64, 1d, C); float64; float64; float64; array(float64, 1d, C); array(float64, 1d, C)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef i32 @loops.condense(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.hessian.0, ptr readnone captures(none) %arg.hessian.1, i64 %arg.hessian.2, i64 %arg.hessian.3, ptr readonly captures(none) %arg.hessian.4, i64 %arg.hessian.5.0, i64 %arg.hessian.6.0, ptr readnone captures(none) %arg.at_hessian.0, ptr readnone captures(none) %arg.at_hessian.1, i64 %arg.at_hessian.2, i64 %arg.at_hessian.3, ptr readonly captures(none) %arg.at_hessian.4, i64 %arg.at_hessian.5.0, i64 %arg.at_hessian.6.0, ptr readnone captures(none) %arg.data.0, ptr readnone captures(none) %arg.data.1, i64 %arg.data.2, i64 %arg.data.3, ptr readonly captures(none) %arg.data.4, i64 %arg.data.5.0, i64 %arg.data.6.0, ptr readnone captures(none) %arg.begins.0, ptr readnone captures(none) %arg.begins.1, i64 %arg.begins.2, i64 %arg.begins.3, ptr readonly captures(none) %arg.begins.4, i64 %arg.begins.5.0, i64 %arg.begins.6.0, ptr readnone captures(none) %arg.places.0, ptr readnone captures(none) %arg.places.1, i64 %arg.places.2, i64 %arg.places.3, ptr readonly captures(none) %arg.places.4, i64 %arg.places.5.0, i64 %arg.places.6.0, ptr readnone captures(none) %arg.at_products.0, ptr readnone captures(none) %arg.at_products.1, i64 %arg.at_products.2, i64 %arg.at_products.3, ptr readonly captures(none) %arg.at_products.4, i64 %arg.at_products.5.0, i64 %arg.at_products.6.0, ptr readnone captures(none) %arg.weights.0, ptr readnone captures(none) %arg.weights.1, i64 %arg.weights.2, i64 %arg.weights.3, ptr readonly captures(none) %arg.weights.4, i64 %arg.weights.5.0, i64 %arg.weights.6.0, ptr readnone captures(none) %arg.filled.0, ptr readnone captures(none) %arg.filled.1, i64 %arg.filled.2, i64 %arg.filled.3, ptr captures(none) %arg.filled.4, i64 %arg.filled.5.0, i64 %arg.filled.6.0) local_unnamed_addr #0 {
B0.endif:
  %.207432.not = icmp slt i64 %arg.at_hessian.5.0, 1
  br i1 %.207432.not, label %B122.endif, label %B62.preheader

B62.preheader:                                    ; preds = %B0.endif
  %0 = icmp eq i64 %arg.at_hessian.5.0, 1
  br i1 %0, label %B62.epil.preheader, label %B62.preheader.new

B62.preheader.new:                                ; preds = %B62.preheader
  %unroll_iter = and i64 %arg.at_hessian.5.0, 9223372036854775806
  br label %B62

B62:                                              ; preds = %B62, %B62.preheader.new
  %.213431433 = phi i64 [ 0, %B62.preheader.new ], [ %.220.1, %B62 ]
  %sunkaddr = shl i64 %.213431433, 3
  %sunkaddr15 = getelementptr i8, ptr %arg.at_hessian.4, i64 %sunkaddr
  %.274 = load i64, ptr %sunkaddr15, align 8
  %.300 = getelementptr double, ptr %arg.filled.4, i64 %.274
  %.301 = load double, ptr %.300, align 8
  %sunkaddr17 = getelementptr i8, ptr %arg.hessian.4, i64 %sunkaddr
  %.331 = load double, ptr %sunkaddr17, align 8
  %.332 = fadd double %.301, %.331
  store double %.332, ptr %.300, align 8
  %.220.1 = add nuw i64 %.213431433, 2
  %sunkaddr20 = getelementptr i8, ptr %sunkaddr15, i64 8
  %.274.1 = load i64, ptr %sunkaddr20, align 8
  %.300.1 = getelementptr double, ptr %arg.filled.4, i64 %.274.1
  %.301.1 = load double, ptr %.300.1, align 8
  %sunkaddr23 = getelementptr i8, ptr %sunkaddr17, i64 8
  %.331.1 = load double, ptr %sunkaddr23, align 8
  %.332.1 = fadd double %.301.1, %.331.1
  store double %.332.1, ptr %.300.1, align 8
  %niter.ncmp.1 = icmp eq i64 %unroll_iter, %.220.1
  br i1 %niter.ncmp.1, label %B122.endif.loopexit.unr-lcssa, label %B62

B178.loopexit:                                    ; preds = %B260.loopexit, %B180.endif
  %exitcond478.not = icmp eq i64 %arg.weights.5.0, %.477
  br i1 %exitcond478.not, label %B430, label %B180.endif

B260.loopexit:                                    ; preds = %B350, %B262.endif
  %p.2.2.lcssa = phi i64 [ %p.3.1454, %B262.endif ], [ %.1058, %B350 ]
  %lsr.iv.next = add i64 %lsr.iv, -1
  %.681 = icmp samesign ugt i64 %.680445453, 1
  br i1 %.681, label %B262.endif, label %B178.loopexit

B350:                                             ; preds = %B350.preheader, %B350
  %lsr.iv3 = phi i64 [ %15, %B350.preheader ], [ %lsr.iv.next4, %B350 ]
  %p.2.2441 = phi i64 [ %p.3.1454, %B350.preheader ], [ %.1058, %B350 ]
  %.907437439 = phi i64 [ %.687446452, %B350.preheader ], [ %.914, %B350 ]
  %.914 = add i64 %.907437439, 1
  %.953 = icmp slt i64 %p.2.2441, 0
  %1 = select i1 %.953, i64 %8, i64 0
  %scevgep = getelementptr i8, ptr %arg.at_products.4, i64 %1
  %2 = shl i64 %p.2.2441, 3
  %scevgep2 = getelementptr i8, ptr %scevgep, i64 %2
  %.969 = load i64, ptr %scevgep2, align 8
  %.995 = getelementptr double, ptr %arg.filled.4, i64 %.969
  %.996 = load double, ptr %.995, align 8
  %.1010 = icmp slt i64 %.907437439, 0
  %3 = select i1 %.1010, i64 %9, i64 0
  %scevgep5 = getelementptr i8, ptr %arg.data.4, i64 %3
  %4 = shl i64 %.907437439, 3
  %scevgep6 = getelementptr i8, ptr %scevgep5, i64 %4
  %.1026 = load double, ptr %scevgep6, align 8
  %.1028 = fmul double %.786, %.1026
  %.1029 = fadd double %.996, %.1028
  store double %.1029, ptr %.995, align 8
  %.1058 = add i64 %p.2.2441, 1
  %lsr.iv.next4 = add i64 %lsr.iv3, -1
  %.901 = icmp samesign ugt i64 %lsr.iv.next4, 1
  br i1 %.901, label %B350, label %B260.loopexit

B430:                                             ; preds = %B178.loopexit, %B122.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B122.endif.loopexit.unr-lcssa:                    ; preds = %B62
  %5 = and i64 %arg.at_hessian.5.0, 1
  %lcmp.mod.not = icmp eq i64 %5, 0
  br i1 %lcmp.mod.not, label %B122.endif, label %B62.epil.preheader

B62.epil.preheader:                               ; preds = %B122.endif.loopexit.unr-lcssa, %B62.preheader
  %.213431433.epil.init = phi i64 [ 0, %B62.preheader ], [ %unroll_iter, %B122.endif.loopexit.unr-lcssa ]
  %6 = getelementptr i64, ptr %arg.at_hessian.4, i64 %.213431433.epil.init
  %.274.epil = load i64, ptr %6, align 8
  %.300.epil = getelementptr double, ptr %arg.filled.4, i64 %.274.epil
  %.301.epil = load double, ptr %.300.epil, align 8
  %7 = getelementptr double, ptr %arg.hessian.4, i64 %.213431433.epil.init
  %.331.epil = load double, ptr %7, align 8
  %.332.epil = fadd double %.301.epil, %.331.epil
  store double %.332.epil, ptr %.300.epil, align 8
  br label %B122.endif

B122.endif:                                       ; preds = %B62.epil.preheader, %B122.endif.loopexit.unr-lcssa, %B0.endif
  %.464467.not = icmp slt i64 %arg.weights.5.0, 1
  br i1 %.464467.not, label %B430, label %B180.endif.preheader

B180.endif.preheader:                             ; preds = %B122.endif
  %8 = shl i64 %arg.at_products.5.0, 3
  %9 = shl i64 %arg.data.5.0, 3
  br label %B180.endif

B180.endif:                                       ; preds = %B180.endif.preheader, %B178.loopexit
  %.470460470 = phi i64 [ %.477, %B178.loopexit ], [ 0, %B180.endif.preheader ]
  %.477 = add nuw nsw i64 %.470460470, 1
  %10 = getelementptr i64, ptr %arg.begins.4, i64 %.470460470
  %.569 = load i64, ptr %10, align 8
  %11 = getelementptr i8, ptr %10, i64 8
  %.601 = load i64, ptr %11, align 8
  %.638 = sub i64 %.601, %.569
  %.681451.not = icmp slt i64 %.638, 1
  br i1 %.681451.not, label %B178.loopexit, label %B262.endif.lr.ph

B262.endif.lr.ph:                                 ; preds = %B180.endif
  %12 = getelementptr i64, ptr %arg.places.4, i64 %.470460470
  %.535 = load i64, ptr %12, align 8
  %13 = sub i64 1, %.569
  %sunkaddr24 = shl i64 %.470460470, 3
  %sunkaddr25 = getelementptr i8, ptr %arg.weights.4, i64 %sunkaddr24
  %sunkaddr27 = getelementptr i8, ptr %arg.begins.4, i64 %sunkaddr24
  %sunkaddr28 = getelementptr i8, ptr %sunkaddr27, i64 8
  br label %B262.endif

B262.endif:                                       ; preds = %B262.endif.lr.ph, %B260.loopexit
  %lsr.iv = phi i64 [ %13, %B262.endif.lr.ph ], [ %lsr.iv.next, %B260.loopexit ]
  %p.3.1454 = phi i64 [ %.535, %B262.endif.lr.ph ], [ %p.2.2.lcssa, %B260.loopexit ]
  %.680445453 = phi i64 [ %.638, %B262.endif.lr.ph ], [ %.690, %B260.loopexit ]
  %.687446452 = phi i64 [ %.569, %B262.endif.lr.ph ], [ %.694, %B260.loopexit ]
  %.690 = add nsw i64 %.680445453, -1
  %.694 = add i64 %.687446452, 1
  %.755 = load double, ptr %sunkaddr25, align 8
  %.769 = icmp slt i64 %.687446452, 0
  %.770 = select i1 %.769, i64 %arg.data.5.0, i64 0
  %14 = getelementptr double, ptr %arg.data.4, i64 %.687446452
  %.784 = getelementptr double, ptr %14, i64 %.770
  %.785 = load double, ptr %.784, align 8
  %.786 = fmul double %.755, %.785
  %.821 = load i64, ptr %sunkaddr28, align 8
  %.858 = sub i64 %.821, %.687446452
  %.901438.not = icmp slt i64 %.858, 1
  br i1 %.901438.not, label %B260.loopexit, label %B350.preheader

B350.preheader:                                   ; preds = %B262.endif
  %15 = add i64 %.821, %lsr.iv
  br label %B350
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef i32 @loops.factorise(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.data.0, ptr readnone captures(none) %arg.data.1, i64 %arg.data.2, i64 %arg.data.3, ptr readonly captures(none) %arg.data.4, i64 %arg.data.5.0, i64 %arg.data.6.0, ptr readnone captures(none) %arg.begins.0, ptr readnone captures(none) %arg.begins.1, i64 %arg.begins.2, i64 %arg.begins.3, ptr readonly captures(none) %arg.begins.4, i64 %arg.begins.5.0, i64 %arg.begins.6.0, ptr readnone captures(none) %arg.rows.0, ptr readnone captures(none) %arg.rows.1, i64 %arg.rows.2, i64 %arg.rows.3, ptr readonly captures(none) %arg.rows.4, i64 %arg.rows.5.0, i64 %arg.rows.6.0, ptr readnone captures(none) %arg.L_begins.0, ptr readnone captures(none) %arg.L_begins.1, i64 %arg.L_begins.2, i64 %arg.L_begins.3, ptr readonly captures(none) %arg.L_begins.4, i64 %arg.L_begins.5.0, i64 %arg.L_begins.6.0, ptr readnone captures(none) %arg.L_rows.0, ptr readnone captures(none) %arg.L_rows.1, i64 %arg.L_rows.2, i64 %arg.L_rows.3, ptr readonly captures(none) %arg.L_rows.4, i64 %arg.L_rows.5.0, i64 %arg.L_rows.6.0, ptr readnone captures(none) %arg.of_row.0, ptr readnone captures(none) %arg.of_row.1, i64 %arg.of_row.2, i64 %arg.of_row.3, ptr readonly captures(none) %arg.of_row.4, i64 %arg.of_row.5.0, i64 %arg.of_row.6.0, ptr readnone captures(none) %arg.L_cols.0, ptr readnone captures(none) %arg.L_cols.1, i64 %arg.L_cols.2, i64 %arg.L_cols.3, ptr readonly captures(none) %arg.L_cols.4, i64 %arg.L_cols.5.0, i64 %arg.L_cols.6.0, ptr readnone captures(none) %arg.full.0, ptr readnone captures(none) %arg.full.1, i64 %arg.full.2, i64 %arg.full.3, ptr captures(none) %arg.full.4, i64 %arg.full.5.0, i64 %arg.full.6.0, ptr readnone captures(none) %arg.y.0, ptr readnone captures(none) %arg.y.1, i64 %arg.y.2, i64 %arg.y.3, ptr captures(none) %arg.y.4, i64 %arg.y.5.0, i64 %arg.y.6.0, ptr readnone captures(none) %arg.L.0, ptr readnone captures(none) %arg.L.1, i64 %arg.L.2, i64 %arg.L.3, ptr captures(none) %arg.L.4, i64 %arg.L.5.0, i64 %arg.L.6.0, ptr readnone captures(none) %arg.D.0, ptr readnone captures(none) %arg.D.1, i64 %arg.D.2, i64 %arg.D.3, ptr captures(none) %arg.D.4, i64 %arg.D.5.0, i64 %arg.D.6.0) local_unnamed_addr #0 {
B0.endif:
  %.205 = icmp sgt i64 %arg.D.5.0, 0
  br i1 %.205, label %B62.preheader, label %B594

B62.preheader:                                    ; preds = %B0.endif
  %arg.full.41 = ptrtoint ptr %arg.full.4 to i64
  %arg.L_begins.42 = ptrtoint ptr %arg.L_begins.4 to i64
  %min.iters.check = icmp samesign ult i64 %arg.D.5.0, 6
  %0 = sub i64 %arg.full.41, %arg.L_begins.42
  %diff.check = icmp ult i64 %0, 32
  %or.cond = select i1 %min.iters.check, i1 true, i1 %diff.check
  br i1 %or.cond, label %B62.preheader4, label %vector.ph

vector.ph:                                        ; preds = %B62.preheader
  %n.vec = and i64 %arg.D.5.0, 9223372036854775804
  br label %vector.body

vector.body:                                      ; preds = %vector.body, %vector.ph
  %index = phi i64 [ 0, %vector.ph ], [ %index.next, %vector.body ]
  %sunkaddr = shl i64 %index, 3
  %sunkaddr64 = getelementptr i8, ptr %arg.L_begins.4, i64 %sunkaddr
  %wide.load = load <2 x i64>, ptr %sunkaddr64, align 8
  %sunkaddr67 = getelementptr i8, ptr %sunkaddr64, i64 16
  %wide.load3 = load <2 x i64>, ptr %sunkaddr67, align 8
  %sunkaddr69 = getelementptr i8, ptr %arg.full.4, i64 %sunkaddr
  store <2 x i64> %wide.load, ptr %sunkaddr69, align 8
  %sunkaddr72 = getelementptr i8, ptr %sunkaddr69, i64 16
  store <2 x i64> %wide.load3, ptr %sunkaddr72, align 8
  %index.next = add nuw nsw i64 %index, 4
  %1 = icmp eq i64 %n.vec, %index.next
  br i1 %1, label %middle.block, label %vector.body, !llvm.loop !0

middle.block:                                     ; preds = %vector.body
  %cmp.n = icmp eq i64 %arg.D.5.0, %n.vec
  br i1 %cmp.n, label %B146.endif.preheader, label %B62.preheader4

B62.preheader4:                                   ; preds = %middle.block, %B62.preheader
  %.255626628.ph = phi i64 [ 0, %B62.preheader ], [ %n.vec, %middle.block ]
  %xtraiter = and i64 %arg.D.5.0, 3
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B62.prol.loopexit, label %B62.prol

B62.prol:                                         ; preds = %B62.preheader4, %B62.prol
  %lsr.iv54 = phi i64 [ %lsr.iv.next55, %B62.prol ], [ %xtraiter, %B62.preheader4 ]
  %.255626628.prol = phi i64 [ %.262.prol, %B62.prol ], [ %.255626628.ph, %B62.preheader4 ]
  %.262.prol = add nuw nsw i64 %.255626628.prol, 1
  %2 = shl i64 %.255626628.prol, 3
  %scevgep53 = getelementptr i8, ptr %arg.L_begins.4, i64 %2
  %.316.prol = load i64, ptr %scevgep53, align 8
  %scevgep52 = getelementptr i8, ptr %arg.full.4, i64 %2
  store i64 %.316.prol, ptr %scevgep52, align 8
  %lsr.iv.next55 = add nsw i64 %lsr.iv54, -1
  %prol.iter.cmp.not = icmp eq i64 %lsr.iv.next55, 0
  br i1 %prol.iter.cmp.not, label %B62.prol.loopexit, label %B62.prol, !llvm.loop !3

B62.prol.loopexit:                                ; preds = %B62.prol, %B62.preheader4
  %.255626628.unr = phi i64 [ %.255626628.ph, %B62.preheader4 ], [ %.262.prol, %B62.prol ]
  %3 = sub nsw i64 %.255626628.ph, %arg.D.5.0
  %4 = icmp ugt i64 %3, -4
  br i1 %4, label %B146.endif.preheader, label %B62

B62:                                              ; preds = %B62.prol.loopexit, %B62
  %.255626628 = phi i64 [ %.262.3, %B62 ], [ %.255626628.unr, %B62.prol.loopexit ]
  %sunkaddr73 = shl i64 %.255626628, 3
  %sunkaddr74 = getelementptr i8, ptr %arg.L_begins.4, i64 %sunkaddr73
  %.316 = load i64, ptr %sunkaddr74, align 8
  %sunkaddr76 = getelementptr i8, ptr %arg.full.4, i64 %sunkaddr73
  store i64 %.316, ptr %sunkaddr76, align 8
  %sunkaddr79 = getelementptr i8, ptr %sunkaddr74, i64 8
  %.316.1 = load i64, ptr %sunkaddr79, align 8
  %sunkaddr82 = getelementptr i8, ptr %sunkaddr76, i64 8
  store i64 %.316.1, ptr %sunkaddr82, align 8
  %sunkaddr85 = getelementptr i8, ptr %sunkaddr74, i64 16
  %.316.2 = load i64, ptr %sunkaddr85, align 8
  %sunkaddr88 = getelementptr i8, ptr %sunkaddr76, i64 16
  store i64 %.316.2, ptr %sunkaddr88, align 8
  %.262.3 = add nuw nsw i64 %.255626628, 4
  %sunkaddr91 = getelementptr i8, ptr %sunkaddr74, i64 24
  %.316.3 = load i64, ptr %sunkaddr91, align 8
  %sunkaddr94 = getelementptr i8, ptr %sunkaddr76, i64 24
  store i64 %.316.3, ptr %sunkaddr94, align 8
  %exitcond.not.3 = icmp eq i64 %arg.D.5.0, %.262.3
  br i1 %exitcond.not.3, label %B146.endif.preheader, label %B62, !llvm.loop !5

B146.endif.preheader:                             ; preds = %B62, %B62.prol.loopexit, %middle.block
  %5 = shl i64 %arg.data.5.0, 3
  %6 = shl i64 %arg.rows.5.0, 3
  %7 = shl i64 %arg.L_rows.5.0, 3
  %8 = shl i64 %arg.L.5.0, 3
  br label %B146.endif

B212:                                             ; preds = %B212.preheader13, %B212
  %lsr.iv = phi i64 [ %30, %B212.preheader13 ], [ %lsr.iv.next, %B212 ]
  %.630632634 = phi i64 [ %.630632634.unr, %B212.preheader13 ], [ %15, %B212 ]
  %.675 = icmp slt i64 %.630632634, 0
  %9 = select i1 %.675, i64 %5, i64 0
  %scevgep16 = getelementptr i8, ptr %arg.data.4, i64 %9
  %10 = shl i64 %.630632634, 3
  %scevgep17 = getelementptr i8, ptr %scevgep16, i64 %10
  %.691 = load double, ptr %scevgep17, align 8
  %11 = select i1 %.675, i64 %6, i64 0
  %scevgep = getelementptr i8, ptr %arg.rows.4, i64 %11
  %scevgep15 = getelementptr i8, ptr %scevgep, i64 %10
  %.721 = load i64, ptr %scevgep15, align 8
  %.747 = getelementptr double, ptr %arg.y.4, i64 %.721
  store double %.691, ptr %.747, align 8
  %12 = add i64 %.630632634, 1
  %.675.1 = icmp slt i64 %12, 0
  %13 = select i1 %.675.1, i64 %5, i64 0
  %scevgep21 = getelementptr i8, ptr %arg.data.4, i64 %13
  %scevgep22 = getelementptr i8, ptr %scevgep21, i64 %10
  %scevgep23 = getelementptr i8, ptr %scevgep22, i64 8
  %.691.1 = load double, ptr %scevgep23, align 8
  %14 = select i1 %.675.1, i64 %6, i64 0
  %scevgep18 = getelementptr i8, ptr %arg.rows.4, i64 %14
  %scevgep19 = getelementptr i8, ptr %scevgep18, i64 %10
  %scevgep20 = getelementptr i8, ptr %scevgep19, i64 8
  %.721.1 = load i64, ptr %scevgep20, align 8
  %.747.1 = getelementptr double, ptr %arg.y.4, i64 %.721.1
  store double %.691.1, ptr %.747.1, align 8
  %lsr.iv.next = add i64 %lsr.iv, -2
  %.624.1 = icmp samesign ugt i64 %lsr.iv.next, 2
  %15 = add i64 %.630632634, 2
  br i1 %.624.1, label %B212, label %B250.endif

B450:                                             ; preds = %B450.preheader12, %B450
  %lsr.iv24 = phi i64 [ %38, %B450.preheader12 ], [ %lsr.iv.next25, %B450 ]
  %.1236639641 = phi i64 [ %.1236639641.unr, %B450.preheader12 ], [ %22, %B450 ]
  %.1281 = icmp slt i64 %.1236639641, 0
  %16 = select i1 %.1281, i64 %7, i64 0
  %scevgep28 = getelementptr i8, ptr %arg.L_rows.4, i64 %16
  %17 = shl i64 %.1236639641, 3
  %scevgep29 = getelementptr i8, ptr %scevgep28, i64 %17
  %.1297 = load i64, ptr %scevgep29, align 8
  %.1323 = getelementptr double, ptr %arg.y.4, i64 %.1297
  %.1324 = load double, ptr %.1323, align 8
  %18 = select i1 %.1281, i64 %8, i64 0
  %scevgep26 = getelementptr i8, ptr %arg.L.4, i64 %18
  %scevgep27 = getelementptr i8, ptr %scevgep26, i64 %17
  %.1354 = load double, ptr %scevgep27, align 8
  %.1356 = fmul double %.1059, %.1354
  %.1357 = fsub double %.1324, %.1356
  store double %.1357, ptr %.1323, align 8
  %19 = add i64 %.1236639641, 1
  %.1281.1 = icmp slt i64 %19, 0
  %20 = select i1 %.1281.1, i64 %7, i64 0
  %scevgep33 = getelementptr i8, ptr %arg.L_rows.4, i64 %20
  %scevgep34 = getelementptr i8, ptr %scevgep33, i64 %17
  %scevgep35 = getelementptr i8, ptr %scevgep34, i64 8
  %.1297.1 = load i64, ptr %scevgep35, align 8
  %.1323.1 = getelementptr double, ptr %arg.y.4, i64 %.1297.1
  %.1324.1 = load double, ptr %.1323.1, align 8
  %21 = select i1 %.1281.1, i64 %8, i64 0
  %scevgep30 = getelementptr i8, ptr %arg.L.4, i64 %21
  %scevgep31 = getelementptr i8, ptr %scevgep30, i64 %17
  %scevgep32 = getelementptr i8, ptr %scevgep31, i64 8
  %.1354.1 = load double, ptr %scevgep32, align 8
  %.1356.1 = fmul double %.1059, %.1354.1
  %.1357.1 = fsub double %.1324.1, %.1356.1
  store double %.1357.1, ptr %.1323.1, align 8
  %lsr.iv.next25 = add i64 %lsr.iv24, -2
  %.1230.1 = icmp samesign ugt i64 %lsr.iv.next25, 2
  %22 = add i64 %.1236639641, 2
  br i1 %.1230.1, label %B450, label %B516

B516:                                             ; preds = %B450, %B450.prol.loopexit, %B342.endif
  %.1416 = getelementptr double, ptr %arg.D.4, i64 %.1028
  %.1417 = load double, ptr %.1416, align 8
  %.1422 = fdiv double %.1059, %.1417
  %.1437 = icmp slt i64 %.1087, 0
  %.1438 = select i1 %.1437, i64 %arg.L.5.0, i64 0
  %23 = getelementptr double, ptr %arg.L.4, i64 %.1087
  %.1452 = getelementptr double, ptr %23, i64 %.1438
  store double %.1422, ptr %.1452, align 8
  %.1455 = fmul double %.1059, %.1422
  %.1459 = fsub double %pivot.2.1654, %.1455
  %.1463 = add nsw i64 %.1087, 1
  %sunkaddr95 = shl i64 %.1028, 3
  %sunkaddr96 = getelementptr i8, ptr %arg.full.4, i64 %sunkaddr95
  store i64 %.1463, ptr %sunkaddr96, align 8
  %.961 = icmp samesign ugt i64 %.960645653, 1
  br i1 %.961, label %B342.endif, label %B582

B582:                                             ; preds = %B516, %B250.endif
  %pivot.2.1.lcssa = phi double [ %.784, %B250.endif ], [ %.1459, %B516 ]
  %24 = getelementptr double, ptr %arg.D.4, i64 %.447661675
  store double %pivot.2.1.lcssa, ptr %24, align 8
  %exitcond685.not = icmp eq i64 %arg.D.5.0, %.454
  br i1 %exitcond685.not, label %B594, label %B146.endif

B594:                                             ; preds = %B582, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B146.endif:                                       ; preds = %B582, %B146.endif.preheader
  %.447661675 = phi i64 [ %.454, %B582 ], [ 0, %B146.endif.preheader ]
  %.454 = add nuw nsw i64 %.447661675, 1
  %25 = getelementptr i64, ptr %arg.begins.4, i64 %.447661675
  %.512 = load i64, ptr %25, align 8
  %26 = getelementptr i64, ptr %arg.begins.4, i64 %.454
  %.544 = load i64, ptr %26, align 8
  %.581 = sub i64 %.544, %.512
  %.624633.not = icmp slt i64 %.581, 1
  br i1 %.624633.not, label %B250.endif, label %B212.preheader

B212.preheader:                                   ; preds = %B146.endif
  %.neg = add i64 %.512, 1
  %xtraiter5 = and i64 %.581, 1
  %lcmp.mod6.not = icmp eq i64 %xtraiter5, 0
  br i1 %lcmp.mod6.not, label %B212.prol.loopexit, label %B212.prol

B212.prol:                                        ; preds = %B212.preheader
  %.633.prol = add nsw i64 %.581, -1
  %.675.prol = icmp slt i64 %.512, 0
  %.676.prol = select i1 %.675.prol, i64 %arg.data.5.0, i64 0
  %27 = getelementptr double, ptr %arg.data.4, i64 %.512
  %.690.prol = getelementptr double, ptr %27, i64 %.676.prol
  %.691.prol = load double, ptr %.690.prol, align 8
  %.706.prol = select i1 %.675.prol, i64 %arg.rows.5.0, i64 0
  %28 = getelementptr i64, ptr %arg.rows.4, i64 %.512
  %.720.prol = getelementptr i64, ptr %28, i64 %.706.prol
  %.721.prol = load i64, ptr %.720.prol, align 8
  %.747.prol = getelementptr double, ptr %arg.y.4, i64 %.721.prol
  store double %.691.prol, ptr %.747.prol, align 8
  br label %B212.prol.loopexit

B212.prol.loopexit:                               ; preds = %B212.prol, %B212.preheader
  %.623631635.unr = phi i64 [ %.581, %B212.preheader ], [ %.633.prol, %B212.prol ]
  %.630632634.unr = phi i64 [ %.512, %B212.preheader ], [ %.neg, %B212.prol ]
  %29 = icmp eq i64 %.544, %.neg
  br i1 %29, label %B250.endif, label %B212.preheader13

B212.preheader13:                                 ; preds = %B212.prol.loopexit
  %30 = add nuw i64 %.623631635.unr, 2
  br label %B212

B250.endif:                                       ; preds = %B212, %B212.prol.loopexit, %B146.endif
  %31 = getelementptr double, ptr %arg.y.4, i64 %.447661675
  %.784 = load double, ptr %31, align 8
  store double 0.000000e+00, ptr %31, align 8
  %32 = getelementptr i64, ptr %arg.of_row.4, i64 %.447661675
  %.849 = load i64, ptr %32, align 8
  %33 = getelementptr i64, ptr %arg.of_row.4, i64 %.454
  %.881 = load i64, ptr %33, align 8
  %.918 = sub i64 %.881, %.849
  %.961651.not = icmp slt i64 %.918, 1
  br i1 %.961651.not, label %B582, label %B342.endif

B342.endif:                                       ; preds = %B250.endif, %B516
  %pivot.2.1654 = phi double [ %.1459, %B516 ], [ %.784, %B250.endif ]
  %.960645653 = phi i64 [ %.970, %B516 ], [ %.918, %B250.endif ]
  %.967646652 = phi i64 [ %.974, %B516 ], [ %.849, %B250.endif ]
  %.970 = add nsw i64 %.960645653, -1
  %.974 = add i64 %.967646652, 1
  %.1012 = icmp slt i64 %.967646652, 0
  %.1013 = select i1 %.1012, i64 %arg.L_cols.5.0, i64 0
  %34 = getelementptr i64, ptr %arg.L_cols.4, i64 %.967646652
  %.1027 = getelementptr i64, ptr %34, i64 %.1013
  %.1028 = load i64, ptr %.1027, align 8
  %.1058 = getelementptr double, ptr %arg.y.4, i64 %.1028
  %.1059 = load double, ptr %.1058, align 8
  %.1086 = getelementptr i64, ptr %arg.full.4, i64 %.1028
  %.1087 = load i64, ptr %.1086, align 8
  store double 0.000000e+00, ptr %.1058, align 8
  %.1148 = getelementptr i64, ptr %arg.L_begins.4, i64 %.1028
  %.1149 = load i64, ptr %.1148, align 8
  %.1187 = sub i64 %.1087, %.1149
  %.1230640.not = icmp slt i64 %.1187, 1
  br i1 %.1230640.not, label %B516, label %B450.preheader

B450.preheader:                                   ; preds = %B342.endif
  %.neg11 = add i64 %.1149, 1
  %xtraiter8 = and i64 %.1187, 1
  %lcmp.mod9.not = icmp eq i64 %xtraiter8, 0
  br i1 %lcmp.mod9.not, label %B450.prol.loopexit, label %B450.prol

B450.prol:                                        ; preds = %B450.preheader
  %.1239.prol = add nsw i64 %.1187, -1
  %.1281.prol = icmp slt i64 %.1149, 0
  %.1282.prol = select i1 %.1281.prol, i64 %arg.L_rows.5.0, i64 0
  %35 = getelementptr i64, ptr %arg.L_rows.4, i64 %.1149
  %.1296.prol = getelementptr i64, ptr %35, i64 %.1282.prol
  %.1297.prol = load i64, ptr %.1296.prol, align 8
  %.1323.prol = getelementptr double, ptr %arg.y.4, i64 %.1297.prol
  %.1324.prol = load double, ptr %.1323.prol, align 8
  %.1339.prol = select i1 %.1281.prol, i64 %arg.L.5.0, i64 0
  %36 = getelementptr double, ptr %arg.L.4, i64 %.1149
  %.1353.prol = getelementptr double, ptr %36, i64 %.1339.prol
  %.1354.prol = load double, ptr %.1353.prol, align 8
  %.1356.prol = fmul double %.1059, %.1354.prol
  %.1357.prol = fsub double %.1324.prol, %.1356.prol
  store double %.1357.prol, ptr %.1323.prol, align 8
  br label %B450.prol.loopexit

B450.prol.loopexit:                               ; preds = %B450.prol, %B450.preheader
  %.1229638642.unr = phi i64 [ %.1187, %B450.preheader ], [ %.1239.prol, %B450.prol ]
  %.1236639641.unr = phi i64 [ %.1149, %B450.preheader ], [ %.neg11, %B450.prol ]
  %37 = icmp eq i64 %.1087, %.neg11
  br i1 %37, label %B516, label %B450.preheader12

B450.preheader12:                                 ; preds = %B450.prol.loopexit
  %38 = add nuw i64 %.1229638642.unr, 2
  br label %B450
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef i32 @loops.substitute(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.L_begins.0, ptr readnone captures(none) %arg.L_begins.1, i64 %arg.L_begins.2, i64 %arg.L_begins.3, ptr readonly captures(none) %arg.L_begins.4, i64 %arg.L_begins.5.0, i64 %arg.L_begins.6.0, ptr readnone captures(none) %arg.L_rows.0, ptr readnone captures(none) %arg.L_rows.1, i64 %arg.L_rows.2, i64 %arg.L_rows.3, ptr readonly captures(none) %arg.L_rows.4, i64 %arg.L_rows.5.0, i64 %arg.L_rows.6.0, ptr readnone captures(none) %arg.L.0, ptr readnone captures(none) %arg.L.1, i64 %arg.L.2, i64 %arg.L.3, ptr readonly captures(none) %arg.L.4, i64 %arg.L.5.0, i64 %arg.L.6.0, ptr readnone captures(none) %arg.D.0, ptr readnone captures(none) %arg.D.1, i64 %arg.D.2, i64 %arg.D.3, ptr readonly captures(none) %arg.D.4, i64 %arg.D.5.0, i64 %arg.D.6.0, ptr readnone captures(none) %arg.x.0, ptr readnone captures(none) %arg.x.1, i64 %arg.x.2, i64 %arg.x.3, ptr captures(none) %arg.x.4, i64 %arg.x.5.0, i64 %arg.x.6.0) local_unnamed_addr #0 {
B0.endif:
  %.arg.x.5.0 = tail call i64 @llvm.smax.i64(i64 %arg.x.5.0, i64 0)
  %.165430.not = icmp slt i64 %arg.x.5.0, 1
  br i1 %.165430.not, label %B448, label %B62.endif.preheader

B62.endif.preheader:                              ; preds = %B0.endif
  %0 = shl i64 %arg.L_rows.5.0, 3
  %1 = shl i64 %arg.L.5.0, 3
  br label %B62.endif

B60.loopexit:                                     ; preds = %B144, %B144.prol.loopexit, %B62.endif
  %exitcond.not = icmp eq i64 %arg.x.5.0, %.178
  br i1 %exitcond.not, label %B280, label %B62.endif

B144:                                             ; preds = %B144.preheader5, %B144
  %lsr.iv15 = phi i64 [ %30, %B144.preheader5 ], [ %lsr.iv.next16, %B144 ]
  %.382419421 = phi i64 [ %.382419421.unr, %B144.preheader5 ], [ %8, %B144 ]
  %.427 = icmp slt i64 %.382419421, 0
  %2 = select i1 %.427, i64 %0, i64 0
  %scevgep19 = getelementptr i8, ptr %arg.L_rows.4, i64 %2
  %3 = shl i64 %.382419421, 3
  %scevgep20 = getelementptr i8, ptr %scevgep19, i64 %3
  %.443 = load i64, ptr %scevgep20, align 8
  %.469 = getelementptr double, ptr %arg.x.4, i64 %.443
  %.470 = load double, ptr %.469, align 8
  %4 = select i1 %.427, i64 %1, i64 0
  %scevgep17 = getelementptr i8, ptr %arg.L.4, i64 %4
  %scevgep18 = getelementptr i8, ptr %scevgep17, i64 %3
  %.500 = load double, ptr %scevgep18, align 8
  %.502 = fmul double %.232, %.500
  %.503 = fsub double %.470, %.502
  store double %.503, ptr %.469, align 8
  %5 = add i64 %.382419421, 1
  %.427.1 = icmp slt i64 %5, 0
  %6 = select i1 %.427.1, i64 %0, i64 0
  %scevgep24 = getelementptr i8, ptr %arg.L_rows.4, i64 %6
  %scevgep25 = getelementptr i8, ptr %scevgep24, i64 %3
  %scevgep26 = getelementptr i8, ptr %scevgep25, i64 8
  %.443.1 = load i64, ptr %scevgep26, align 8
  %.469.1 = getelementptr double, ptr %arg.x.4, i64 %.443.1
  %.470.1 = load double, ptr %.469.1, align 8
  %7 = select i1 %.427.1, i64 %1, i64 0
  %scevgep21 = getelementptr i8, ptr %arg.L.4, i64 %7
  %scevgep22 = getelementptr i8, ptr %scevgep21, i64 %3
  %scevgep23 = getelementptr i8, ptr %scevgep22, i64 8
  %.500.1 = load double, ptr %scevgep23, align 8
  %.502.1 = fmul double %.232, %.500.1
  %.503.1 = fsub double %.470.1, %.502.1
  store double %.503.1, ptr %.469.1, align 8
  %lsr.iv.next16 = add i64 %lsr.iv15, -2
  %.376.1 = icmp samesign ugt i64 %lsr.iv.next16, 2
  %8 = add i64 %.382419421, 2
  br i1 %.376.1, label %B144, label %B60.loopexit

B280:                                             ; preds = %B60.loopexit, %B436
  %.632446454 = phi i64 [ %.642, %B436 ], [ %.arg.x.5.0, %B60.loopexit ]
  %.639447453.in = phi i64 [ %.639447453, %B436 ], [ %arg.x.5.0, %B60.loopexit ]
  %.639447453 = add i64 %.639447453.in, -1
  %.642 = add nsw i64 %.632446454, -1
  %.688 = icmp slt i64 %.639447453, 0
  %.689 = select i1 %.688, i64 %arg.x.5.0, i64 0
  %9 = getelementptr double, ptr %arg.x.4, i64 %.639447453
  %.703 = getelementptr double, ptr %9, i64 %.689
  %.704 = load double, ptr %.703, align 8
  %.720 = select i1 %.688, i64 %arg.D.5.0, i64 0
  %10 = getelementptr double, ptr %arg.D.4, i64 %.639447453
  %.734 = getelementptr double, ptr %10, i64 %.720
  %.735 = load double, ptr %.734, align 8
  %.739 = fdiv double %.704, %.735
  %.758 = select i1 %.688, i64 %arg.L_begins.5.0, i64 0
  %11 = getelementptr i64, ptr %arg.L_begins.4, i64 %.639447453
  %.772 = getelementptr i64, ptr %11, i64 %.758
  %.773 = load i64, ptr %.772, align 8
  %.789 = icmp ugt i64 %.639447453.in, -9223372036854775808
  %.790 = select i1 %.789, i64 %arg.L_begins.5.0, i64 0
  %12 = getelementptr i8, ptr %11, i64 8
  %.804 = getelementptr i64, ptr %12, i64 %.790
  %.805 = load i64, ptr %.804, align 8
  %.842 = sub i64 %.805, %.773
  %.885439.not = icmp slt i64 %.842, 1
  br i1 %.885439.not, label %B436, label %B380.preheader

B380.preheader:                                   ; preds = %B280
  %.neg3 = add i64 %.773, 1
  %xtraiter1 = and i64 %.842, 1
  %lcmp.mod2.not = icmp eq i64 %xtraiter1, 0
  br i1 %lcmp.mod2.not, label %B380.prol.loopexit, label %B380.prol

B380.prol:                                        ; preds = %B380.preheader
  %.894.prol = add nsw i64 %.842, -1
  %.936.prol = icmp slt i64 %.773, 0
  %.937.prol = select i1 %.936.prol, i64 %arg.L.5.0, i64 0
  %13 = getelementptr double, ptr %arg.L.4, i64 %.773
  %.951.prol = getelementptr double, ptr %13, i64 %.937.prol
  %.952.prol = load double, ptr %.951.prol, align 8
  %.967.prol = select i1 %.936.prol, i64 %arg.L_rows.5.0, i64 0
  %14 = getelementptr i64, ptr %arg.L_rows.4, i64 %.773
  %.981.prol = getelementptr i64, ptr %14, i64 %.967.prol
  %.982.prol = load i64, ptr %.981.prol, align 8
  %.1008.prol = getelementptr double, ptr %arg.x.4, i64 %.982.prol
  %.1009.prol = load double, ptr %.1008.prol, align 8
  %.1010.prol = fmul double %.952.prol, %.1009.prol
  %.1012.prol = fsub double %.739, %.1010.prol
  br label %B380.prol.loopexit

B380.prol.loopexit:                               ; preds = %B380.prol, %B380.preheader
  %total.2.1442.unr = phi double [ %.739, %B380.preheader ], [ %.1012.prol, %B380.prol ]
  %.884437441.unr = phi i64 [ %.842, %B380.preheader ], [ %.894.prol, %B380.prol ]
  %.891438440.unr = phi i64 [ %.773, %B380.preheader ], [ %.neg3, %B380.prol ]
  %.1012.lcssa.unr = phi double [ poison, %B380.preheader ], [ %.1012.prol, %B380.prol ]
  %15 = icmp eq i64 %.805, %.neg3
  br i1 %15, label %B436, label %B380.preheader4

B380.preheader4:                                  ; preds = %B380.prol.loopexit
  %16 = add nuw i64 %.884437441.unr, 2
  br label %B380

B380:                                             ; preds = %B380, %B380.preheader4
  %lsr.iv = phi i64 [ %16, %B380.preheader4 ], [ %lsr.iv.next, %B380 ]
  %total.2.1442 = phi double [ %total.2.1442.unr, %B380.preheader4 ], [ %.1012.1, %B380 ]
  %.891438440 = phi i64 [ %.891438440.unr, %B380.preheader4 ], [ %23, %B380 ]
  %.936 = icmp slt i64 %.891438440, 0
  %17 = select i1 %.936, i64 %1, i64 0
  %scevgep7 = getelementptr i8, ptr %arg.L.4, i64 %17
  %18 = shl i64 %.891438440, 3
  %scevgep8 = getelementptr i8, ptr %scevgep7, i64 %18
  %.952 = load double, ptr %scevgep8, align 8
  %19 = select i1 %.936, i64 %0, i64 0
  %scevgep = getelementptr i8, ptr %arg.L_rows.4, i64 %19
  %scevgep6 = getelementptr i8, ptr %scevgep, i64 %18
  %.982 = load i64, ptr %scevgep6, align 8
  %.1008 = getelementptr double, ptr %arg.x.4, i64 %.982
  %.1009 = load double, ptr %.1008, align 8
  %.1010 = fmul double %.952, %.1009
  %.1012 = fsub double %total.2.1442, %.1010
  %20 = add i64 %.891438440, 1
  %.936.1 = icmp slt i64 %20, 0
  %21 = select i1 %.936.1, i64 %1, i64 0
  %scevgep12 = getelementptr i8, ptr %arg.L.4, i64 %21
  %scevgep13 = getelementptr i8, ptr %scevgep12, i64 %18
  %scevgep14 = getelementptr i8, ptr %scevgep13, i64 8
  %.952.1 = load double, ptr %scevgep14, align 8
  %22 = select i1 %.936.1, i64 %0, i64 0
  %scevgep9 = getelementptr i8, ptr %arg.L_rows.4, i64 %22
  %scevgep10 = getelementptr i8, ptr %scevgep9, i64 %18
  %scevgep11 = getelementptr i8, ptr %scevgep10, i64 8
  %.982.1 = load i64, ptr %scevgep11, align 8
  %.1008.1 = getelementptr double, ptr %arg.x.4, i64 %.982.1
  %.1009.1 = load double, ptr %.1008.1, align 8
  %.1010.1 = fmul double %.952.1, %.1009.1
  %.1012.1 = fsub double %.1012, %.1010.1
  %lsr.iv.next = add i64 %lsr.iv, -2
  %.885.1 = icmp samesign ugt i64 %lsr.iv.next, 2
  %23 = add i64 %.891438440, 2
  br i1 %.885.1, label %B380, label %B436

B436:                                             ; preds = %B380, %B380.prol.loopexit, %B280
  %total.2.1.lcssa = phi double [ %.739, %B280 ], [ %.1012.lcssa.unr, %B380.prol.loopexit ], [ %.1012.1, %B380 ]
  %sunkaddr = shl i64 %.689, 3
  %sunkaddr27 = getelementptr inbounds i8, ptr %9, i64 %sunkaddr
  store double %total.2.1.lcssa, ptr %sunkaddr27, align 8
  %.633 = icmp sgt i64 %.632446454, 1
  br i1 %.633, label %B280, label %B448

B448:                                             ; preds = %B436, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B62.endif:                                        ; preds = %B62.endif.preheader, %B60.loopexit
  %.171425431 = phi i64 [ %.178, %B60.loopexit ], [ 0, %B62.endif.preheader ]
  %.178 = add nuw nsw i64 %.171425431, 1
  %24 = getelementptr double, ptr %arg.x.4, i64 %.171425431
  %.232 = load double, ptr %24, align 8
  %25 = getelementptr i64, ptr %arg.L_begins.4, i64 %.171425431
  %.265 = load i64, ptr %25, align 8
  %26 = getelementptr i8, ptr %25, i64 8
  %.296 = load i64, ptr %26, align 8
  %.333 = sub i64 %.296, %.265
  %.376420.not = icmp slt i64 %.333, 1
  br i1 %.376420.not, label %B60.loopexit, label %B144.preheader

B144.preheader:                                   ; preds = %B62.endif
  %.neg = add i64 %.265, 1
  %xtraiter = and i64 %.333, 1
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B144.prol.loopexit, label %B144.prol

B144.prol:                                        ; preds = %B144.preheader
  %.385.prol = add nsw i64 %.333, -1
  %.427.prol = icmp slt i64 %.265, 0
  %.428.prol = select i1 %.427.prol, i64 %arg.L_rows.5.0, i64 0
  %27 = getelementptr i64, ptr %arg.L_rows.4, i64 %.265
  %.442.prol = getelementptr i64, ptr %27, i64 %.428.prol
  %.443.prol = load i64, ptr %.442.prol, align 8
  %.469.prol = getelementptr double, ptr %arg.x.4, i64 %.443.prol
  %.470.prol = load double, ptr %.469.prol, align 8
  %.485.prol = select i1 %.427.prol, i64 %arg.L.5.0, i64 0
  %28 = getelementptr double, ptr %arg.L.4, i64 %.265
  %.499.prol = getelementptr double, ptr %28, i64 %.485.prol
  %.500.prol = load double, ptr %.499.prol, align 8
  %.502.prol = fmul double %.232, %.500.prol
  %.503.prol = fsub double %.470.prol, %.502.prol
  store double %.503.prol, ptr %.469.prol, align 8
  br label %B144.prol.loopexit

B144.prol.loopexit:                               ; preds = %B144.prol, %B144.preheader
  %.375418422.unr = phi i64 [ %.333, %B144.preheader ], [ %.385.prol, %B144.prol ]
  %.382419421.unr = phi i64 [ %.265, %B144.preheader ], [ %.neg, %B144.prol ]
  %29 = icmp eq i64 %.296, %.neg
  br i1 %29, label %B60.loopexit, label %B144.preheader5

B144.preheader5:                                  ; preds = %B144.prol.loopexit
  %30 = add nuw i64 %.375418422.unr, 2
  br label %B144
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef i32 @loops.subtract_product(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.data.0, ptr readnone captures(none) %arg.data.1, i64 %arg.data.2, i64 %arg.data.3, ptr readonly captures(none) %arg.data.4, i64 %arg.data.5.0, i64 %arg.data.6.0, ptr readnone captures(none) %arg.begins.0, ptr readnone captures(none) %arg.begins.1, i64 %arg.begins.2, i64 %arg.begins.3, ptr readonly captures(none) %arg.begins.4, i64 %arg.begins.5.0, i64 %arg.begins.6.0, ptr readnone captures(none) %arg.rows.0, ptr readnone captures(none) %arg.rows.1, i64 %arg.rows.2, i64 %arg.rows.3, ptr readonly captures(none) %arg.rows.4, i64 %arg.rows.5.0, i64 %arg.rows.6.0, ptr readnone captures(none) %arg.x.0, ptr readnone captures(none) %arg.x.1, i64 %arg.x.2, i64 %arg.x.3, ptr readonly captures(none) %arg.x.4, i64 %arg.x.5.0, i64 %arg.x.6.0, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.6.0) local_unnamed_addr #0 {
B0.endif:
  %.165312.not = icmp slt i64 %arg.x.5.0, 1
  br i1 %.165312.not, label %B328, label %B62.endif.preheader

B62.endif.preheader:                              ; preds = %B0.endif
  %0 = shl i64 %arg.data.5.0, 3
  %1 = shl i64 %arg.rows.5.0, 3
  br label %B62.endif

B176:                                             ; preds = %B176.preheader, %B176
  %lsr.iv = phi i64 [ %10, %B176.preheader ], [ %lsr.iv.next, %B176 ]
  %total.2.1303 = phi double [ %.304, %B176.preheader ], [ %.545, %B176 ]
  %.424299301 = phi i64 [ %.338, %B176.preheader ], [ %.431, %B176 ]
  %.431 = add i64 %.424299301, 1
  %.469 = icmp slt i64 %.424299301, 0
  %2 = select i1 %.469, i64 %0, i64 0
  %scevgep2 = getelementptr i8, ptr %arg.data.4, i64 %2
  %3 = shl i64 %.424299301, 3
  %scevgep3 = getelementptr i8, ptr %scevgep2, i64 %3
  %.485 = load double, ptr %scevgep3, align 8
  %4 = select i1 %.469, i64 %1, i64 0
  %scevgep = getelementptr i8, ptr %arg.rows.4, i64 %4
  %scevgep1 = getelementptr i8, ptr %scevgep, i64 %3
  %.515 = load i64, ptr %scevgep1, align 8
  %.541 = getelementptr double, ptr %arg.x.4, i64 %.515
  %.542 = load double, ptr %.541, align 8
  %.543 = fmul double %.485, %.542
  %.545 = fadd double %total.2.1303, %.543
  %.603 = getelementptr double, ptr %arg.out.4, i64 %.515
  %.604 = load double, ptr %.603, align 8
  %.636 = fmul double %.236, %.485
  %.637 = fsub double %.604, %.636
  store double %.637, ptr %.603, align 8
  %lsr.iv.next = add i64 %lsr.iv, -1
  %.418 = icmp samesign ugt i64 %lsr.iv.next, 1
  br i1 %.418, label %B176, label %B294

B294:                                             ; preds = %B176, %B62.endif
  %total.2.1.lcssa = phi double [ %.304, %B62.endif ], [ %.545, %B176 ]
  %5 = getelementptr double, ptr %arg.out.4, i64 %.171307313
  %.702 = load double, ptr %5, align 8
  %.704 = fsub double %.702, %total.2.1.lcssa
  store double %.704, ptr %5, align 8
  %exitcond.not = icmp eq i64 %arg.x.5.0, %.178
  br i1 %exitcond.not, label %B328, label %B62.endif

B328:                                             ; preds = %B294, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B62.endif:                                        ; preds = %B62.endif.preheader, %B294
  %.171307313 = phi i64 [ %.178, %B294 ], [ 0, %B62.endif.preheader ]
  %.178 = add nuw nsw i64 %.171307313, 1
  %6 = getelementptr double, ptr %arg.x.4, i64 %.171307313
  %.236 = load double, ptr %6, align 8
  %7 = getelementptr i64, ptr %arg.begins.4, i64 %.171307313
  %8 = getelementptr i8, ptr %7, i64 8
  %.268 = load i64, ptr %8, align 8
  %.269 = add nsw i64 %.268, -1
  %.286.inv = icmp sgt i64 %.268, 0
  %.287 = select i1 %.286.inv, i64 0, i64 %arg.data.5.0
  %9 = getelementptr double, ptr %arg.data.4, i64 %.269
  %.301 = getelementptr double, ptr %9, i64 %.287
  %.302 = load double, ptr %.301, align 8
  %.304 = fmul double %.236, %.302
  %.338 = load i64, ptr %7, align 8
  %.375 = sub i64 %.269, %.338
  %.418300.not = icmp slt i64 %.375, 1
  br i1 %.418300.not, label %B294, label %B176.preheader

B176.preheader:                                   ; preds = %B62.endif
  %10 = sub i64 %.268, %.338
  br label %B176
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef i32 @loops.add_transposed(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.data.0, ptr readnone captures(none) %arg.data.1, i64 %arg.data.2, i64 %arg.data.3, ptr readonly captures(none) %arg.data.4, i64 %arg.data.5.0, i64 %arg.data.6.0, ptr readnone captures(none) %arg.begins.0, ptr readnone captures(none) %arg.begins.1, i64 %arg.begins.2, i64 %arg.begins.3, ptr readonly captures(none) %arg.begins.4, i64 %arg.begins.5.0, i64 %arg.begins.6.0, ptr readnone captures(none) %arg.cols.0, ptr readnone captures(none) %arg.cols.1, i64 %arg.cols.2, i64 %arg.cols.3, ptr readonly captures(none) %arg.cols.4, i64 %arg.cols.5.0, i64 %arg.cols.6.0, ptr readnone captures(none) %arg.y.0, ptr readnone captures(none) %arg.y.1, i64 %arg.y.2, i64 %arg.y.3, ptr readonly captures(none) %arg.y.4, i64 %arg.y.5.0, i64 %arg.y.6.0, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.6.0) local_unnamed_addr #0 {
B0.endif:
  %.165226.not = icmp slt i64 %arg.y.5.0, 1
  br i1 %.165226.not, label %B212, label %B62.endif.preheader

B62.endif.preheader:                              ; preds = %B0.endif
  %0 = shl i64 %arg.cols.5.0, 3
  %1 = shl i64 %arg.data.5.0, 3
  br label %B62.endif

B60.loopexit:                                     ; preds = %B144, %B144.prol.loopexit, %B62.endif
  %exitcond.not = icmp eq i64 %arg.y.5.0, %.178
  br i1 %exitcond.not, label %B212, label %B62.endif

B144:                                             ; preds = %B144.preheader1, %B144
  %lsr.iv = phi i64 [ %15, %B144.preheader1 ], [ %lsr.iv.next, %B144 ]
  %.382215217 = phi i64 [ %.382215217.unr, %B144.preheader1 ], [ %8, %B144 ]
  %.427 = icmp slt i64 %.382215217, 0
  %2 = select i1 %.427, i64 %0, i64 0
  %scevgep3 = getelementptr i8, ptr %arg.cols.4, i64 %2
  %3 = shl i64 %.382215217, 3
  %scevgep4 = getelementptr i8, ptr %scevgep3, i64 %3
  %.443 = load i64, ptr %scevgep4, align 8
  %.469 = getelementptr double, ptr %arg.out.4, i64 %.443
  %.470 = load double, ptr %.469, align 8
  %4 = select i1 %.427, i64 %1, i64 0
  %scevgep = getelementptr i8, ptr %arg.data.4, i64 %4
  %scevgep2 = getelementptr i8, ptr %scevgep, i64 %3
  %.500 = load double, ptr %scevgep2, align 8
  %.502 = fmul double %.232, %.500
  %.503 = fadd double %.470, %.502
  store double %.503, ptr %.469, align 8
  %5 = add i64 %.382215217, 1
  %.427.1 = icmp slt i64 %5, 0
  %6 = select i1 %.427.1, i64 %0, i64 0
  %scevgep8 = getelementptr i8, ptr %arg.cols.4, i64 %6
  %scevgep9 = getelementptr i8, ptr %scevgep8, i64 %3
  %scevgep10 = getelementptr i8, ptr %scevgep9, i64 8
  %.443.1 = load i64, ptr %scevgep10, align 8
  %.469.1 = getelementptr double, ptr %arg.out.4, i64 %.443.1
  %.470.1 = load double, ptr %.469.1, align 8
  %7 = select i1 %.427.1, i64 %1, i64 0
  %scevgep5 = getelementptr i8, ptr %arg.data.4, i64 %7
  %scevgep6 = getelementptr i8, ptr %scevgep5, i64 %3
  %scevgep7 = getelementptr i8, ptr %scevgep6, i64 8
  %.500.1 = load double, ptr %scevgep7, align 8
  %.502.1 = fmul double %.232, %.500.1
  %.503.1 = fadd double %.470.1, %.502.1
  store double %.503.1, ptr %.469.1, align 8
  %lsr.iv.next = add i64 %lsr.iv, -2
  %.376.1 = icmp samesign ugt i64 %lsr.iv.next, 2
  %8 = add i64 %.382215217, 2
  br i1 %.376.1, label %B144, label %B60.loopexit

B212:                                             ; preds = %B60.loopexit, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B62.endif:                                        ; preds = %B62.endif.preheader, %B60.loopexit
  %.171221227 = phi i64 [ %.178, %B60.loopexit ], [ 0, %B62.endif.preheader ]
  %.178 = add nuw nsw i64 %.171221227, 1
  %9 = getelementptr double, ptr %arg.y.4, i64 %.171221227
  %.232 = load double, ptr %9, align 8
  %10 = getelementptr i64, ptr %arg.begins.4, i64 %.171221227
  %.265 = load i64, ptr %10, align 8
  %11 = getelementptr i8, ptr %10, i64 8
  %.296 = load i64, ptr %11, align 8
  %.333 = sub i64 %.296, %.265
  %.376216.not = icmp slt i64 %.333, 1
  br i1 %.376216.not, label %B60.loopexit, label %B144.preheader

B144.preheader:                                   ; preds = %B62.endif
  %.neg = add i64 %.265, 1
  %xtraiter = and i64 %.333, 1
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B144.prol.loopexit, label %B144.prol

B144.prol:                                        ; preds = %B144.preheader
  %.385.prol = add nsw i64 %.333, -1
  %.427.prol = icmp slt i64 %.265, 0
  %.428.prol = select i1 %.427.prol, i64 %arg.cols.5.0, i64 0
  %12 = getelementptr i64, ptr %arg.cols.4, i64 %.265
  %.442.prol = getelementptr i64, ptr %12, i64 %.428.prol
  %.443.prol = load i64, ptr %.442.prol, align 8
  %.469.prol = getelementptr double, ptr %arg.out.4, i64 %.443.prol
  %.470.prol = load double, ptr %.469.prol, align 8
  %.485.prol = select i1 %.427.prol, i64 %arg.data.5.0, i64 0
  %13 = getelementptr double, ptr %arg.data.4, i64 %.265
  %.499.prol = getelementptr double, ptr %13, i64 %.485.prol
  %.500.prol = load double, ptr %.499.prol, align 8
  %.502.prol = fmul double %.232, %.500.prol
  %.503.prol = fadd double %.470.prol, %.502.prol
  store double %.503.prol, ptr %.469.prol, align 8
  br label %B144.prol.loopexit

B144.prol.loopexit:                               ; preds = %B144.prol, %B144.preheader
  %.375214218.unr = phi i64 [ %.333, %B144.preheader ], [ %.385.prol, %B144.prol ]
  %.382215217.unr = phi i64 [ %.265, %B144.preheader ], [ %.neg, %B144.prol ]
  %14 = icmp eq i64 %.296, %.neg
  br i1 %14, label %B60.loopexit, label %B144.preheader1

B144.preheader1:                                  ; preds = %B144.prol.loopexit
  %15 = add nuw i64 %.375214218.unr, 2
  br label %B144
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef i32 @loops.times(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.data.0, ptr readnone captures(none) %arg.data.1, i64 %arg.data.2, i64 %arg.data.3, ptr readonly captures(none) %arg.data.4, i64 %arg.data.5.0, i64 %arg.data.6.0, ptr readnone captures(none) %arg.begins.0, ptr readnone captures(none) %arg.begins.1, i64 %arg.begins.2, i64 %arg.begins.3, ptr readonly captures(none) %arg.begins.4, i64 %arg.begins.5.0, i64 %arg.begins.6.0, ptr readnone captures(none) %arg.cols.0, ptr readnone captures(none) %arg.cols.1, i64 %arg.cols.2, i64 %arg.cols.3, ptr readonly captures(none) %arg.cols.4, i64 %arg.cols.5.0, i64 %arg.cols.6.0, ptr readnone captures(none) %arg.x.0, ptr readnone captures(none) %arg.x.1, i64 %arg.x.2, i64 %arg.x.3, ptr readonly captures(none) %arg.x.4, i64 %arg.x.5.0, i64 %arg.x.6.0, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr writeonly captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.6.0) local_unnamed_addr #0 {
B0.endif:
  %.165219.not = icmp slt i64 %arg.out.5.0, 1
  br i1 %.165219.not, label %B200, label %B62.endif.preheader

B62.endif.preheader:                              ; preds = %B0.endif
  %0 = shl i64 %arg.data.5.0, 3
  %1 = shl i64 %arg.cols.5.0, 3
  br label %B62.endif

B132:                                             ; preds = %B132.preheader1, %B132
  %lsr.iv = phi i64 [ %15, %B132.preheader1 ], [ %lsr.iv.next, %B132 ]
  %total.2.1210 = phi double [ %total.2.1210.unr, %B132.preheader1 ], [ %.478.1, %B132 ]
  %.357206208 = phi i64 [ %.357206208.unr, %B132.preheader1 ], [ %8, %B132 ]
  %.402 = icmp slt i64 %.357206208, 0
  %2 = select i1 %.402, i64 %0, i64 0
  %scevgep3 = getelementptr i8, ptr %arg.data.4, i64 %2
  %3 = shl i64 %.357206208, 3
  %scevgep4 = getelementptr i8, ptr %scevgep3, i64 %3
  %.418 = load double, ptr %scevgep4, align 8
  %4 = select i1 %.402, i64 %1, i64 0
  %scevgep = getelementptr i8, ptr %arg.cols.4, i64 %4
  %scevgep2 = getelementptr i8, ptr %scevgep, i64 %3
  %.448 = load i64, ptr %scevgep2, align 8
  %.474 = getelementptr double, ptr %arg.x.4, i64 %.448
  %.475 = load double, ptr %.474, align 8
  %.476 = fmul double %.418, %.475
  %.478 = fadd double %total.2.1210, %.476
  %5 = add i64 %.357206208, 1
  %.402.1 = icmp slt i64 %5, 0
  %6 = select i1 %.402.1, i64 %0, i64 0
  %scevgep8 = getelementptr i8, ptr %arg.data.4, i64 %6
  %scevgep9 = getelementptr i8, ptr %scevgep8, i64 %3
  %scevgep10 = getelementptr i8, ptr %scevgep9, i64 8
  %.418.1 = load double, ptr %scevgep10, align 8
  %7 = select i1 %.402.1, i64 %1, i64 0
  %scevgep5 = getelementptr i8, ptr %arg.cols.4, i64 %7
  %scevgep6 = getelementptr i8, ptr %scevgep5, i64 %3
  %scevgep7 = getelementptr i8, ptr %scevgep6, i64 8
  %.448.1 = load i64, ptr %scevgep7, align 8
  %.474.1 = getelementptr double, ptr %arg.x.4, i64 %.448.1
  %.475.1 = load double, ptr %.474.1, align 8
  %.476.1 = fmul double %.418.1, %.475.1
  %.478.1 = fadd double %.478, %.476.1
  %lsr.iv.next = add i64 %lsr.iv, -2
  %.351.1 = icmp samesign ugt i64 %lsr.iv.next, 2
  %8 = add i64 %.357206208, 2
  br i1 %.351.1, label %B132, label %B188

B188:                                             ; preds = %B132, %B132.prol.loopexit, %B62.endif
  %total.2.1.lcssa = phi double [ 0.000000e+00, %B62.endif ], [ %.478.lcssa.unr, %B132.prol.loopexit ], [ %.478.1, %B132 ]
  %9 = getelementptr double, ptr %arg.out.4, i64 %.171214220
  store double %total.2.1.lcssa, ptr %9, align 8
  %exitcond.not = icmp eq i64 %arg.out.5.0, %.178
  br i1 %exitcond.not, label %B200, label %B62.endif

B200:                                             ; preds = %B188, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B62.endif:                                        ; preds = %B62.endif.preheader, %B188
  %.171214220 = phi i64 [ %.178, %B188 ], [ 0, %B62.endif.preheader ]
  %.178 = add nuw nsw i64 %.171214220, 1
  %10 = getelementptr i64, ptr %arg.begins.4, i64 %.171214220
  %.239 = load i64, ptr %10, align 8
  %11 = getelementptr i8, ptr %10, i64 8
  %.271 = load i64, ptr %11, align 8
  %.308 = sub i64 %.271, %.239
  %.351207.not = icmp slt i64 %.308, 1
  br i1 %.351207.not, label %B188, label %B132.preheader

B132.preheader:                                   ; preds = %B62.endif
  %.neg = add i64 %.239, 1
  %xtraiter = and i64 %.308, 1
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B132.prol.loopexit, label %B132.prol

B132.prol:                                        ; preds = %B132.preheader
  %.360.prol = add nsw i64 %.308, -1
  %.402.prol = icmp slt i64 %.239, 0
  %.403.prol = select i1 %.402.prol, i64 %arg.data.5.0, i64 0
  %12 = getelementptr double, ptr %arg.data.4, i64 %.239
  %.417.prol = getelementptr double, ptr %12, i64 %.403.prol
  %.418.prol = load double, ptr %.417.prol, align 8
  %.433.prol = select i1 %.402.prol, i64 %arg.cols.5.0, i64 0
  %13 = getelementptr i64, ptr %arg.cols.4, i64 %.239
  %.447.prol = getelementptr i64, ptr %13, i64 %.433.prol
  %.448.prol = load i64, ptr %.447.prol, align 8
  %.474.prol = getelementptr double, ptr %arg.x.4, i64 %.448.prol
  %.475.prol = load double, ptr %.474.prol, align 8
  %.476.prol = fmul double %.418.prol, %.475.prol
  %.478.prol = fadd double %.476.prol, 0.000000e+00
  br label %B132.prol.loopexit

B132.prol.loopexit:                               ; preds = %B132.prol, %B132.preheader
  %total.2.1210.unr = phi double [ 0.000000e+00, %B132.preheader ], [ %.478.prol, %B132.prol ]
  %.350205209.unr = phi i64 [ %.308, %B132.preheader ], [ %.360.prol, %B132.prol ]
  %.357206208.unr = phi i64 [ %.239, %B132.preheader ], [ %.neg, %B132.prol ]
  %.478.lcssa.unr = phi double [ poison, %B132.preheader ], [ %.478.prol, %B132.prol ]
  %14 = icmp eq i64 %.271, %.neg
  br i1 %14, label %B188, label %B132.preheader1

B132.preheader1:                                  ; preds = %B132.prol.loopexit
  %15 = add nuw i64 %.350205209.unr, 2
  br label %B132
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.measure(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.v.0, ptr readnone captures(none) %arg.v.1, i64 %arg.v.2, i64 %arg.v.3, ptr readonly captures(none) %arg.v.4, i64 %arg.v.5.0, i64 %arg.v.6.0, ptr readnone captures(none) %arg.low.0, ptr readnone captures(none) %arg.low.1, i64 %arg.low.2, i64 %arg.low.3, ptr readonly captures(none) %arg.low.4, i64 %arg.low.5.0, i64 %arg.low.6.0, ptr readnone captures(none) %arg.high.0, ptr readnone captures(none) %arg.high.1, i64 %arg.high.2, i64 %arg.high.3, ptr readonly captures(none) %arg.high.4, i64 %arg.high.5.0, i64 %arg.high.6.0, ptr readnone captures(none) %arg.g.0, ptr readnone captures(none) %arg.g.1, i64 %arg.g.2, i64 %arg.g.3, ptr readonly captures(none) %arg.g.4, i64 %arg.g.5.0, i64 %arg.g.6.0, ptr readnone captures(none) %arg.equations.0, ptr readnone captures(none) %arg.equations.1, i64 %arg.equations.2, i64 %arg.equations.3, ptr readonly captures(none) %arg.equations.4, i64 %arg.equations.5.0, i64 %arg.equations.6.0, ptr readnone captures(none) %arg.others.0, ptr readnone captures(none) %arg.others.1, i64 %arg.others.2, i64 %arg.others.3, ptr readonly captures(none) %arg.others.4, i64 %arg.others.5.0, i64 %arg.others.6.0, ptr readnone captures(none) %arg.target.0, ptr readnone captures(none) %arg.target.1, i64 %arg.target.2, i64 %arg.target.3, ptr readonly captures(none) %arg.target.4, i64 %arg.target.5.0, i64 %arg.target.6.0, ptr readnone captures(none) %arg.missed.0, ptr readnone captures(none) %arg.missed.1, i64 %arg.missed.2, i64 %arg.missed.3, ptr writeonly captures(none) %arg.missed.4, i64 %arg.missed.5.0, i64 %arg.missed.6.0, ptr readnone captures(none) %arg.slack.0, ptr readnone captures(none) %arg.slack.1, i64 %arg.slack.2, i64 %arg.slack.3, ptr writeonly captures(none) %arg.slack.4, i64 %arg.slack.5.0, i64 %arg.slack.6.0, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr writeonly captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.6.0) local_unnamed_addr #0 {
B0.endif:
  %.164 = sub i64 %arg.v.5.0, %arg.others.5.0
  %.265539.not = icmp slt i64 %arg.equations.5.0, 1
  br i1 %.265539.not, label %B306.endif, label %B130.backedge

B130.backedge:                                    ; preds = %B0.endif, %B130.backedge
  %total.3.0543 = phi double [ %.453, %B130.backedge ], [ 0.000000e+00, %B0.endif ]
  %most.3.0542 = phi double [ %.13.i, %B130.backedge ], [ 0.000000e+00, %B0.endif ]
  %.271538540 = phi i64 [ %.278, %B130.backedge ], [ 0, %B0.endif ]
  %0 = shl i64 %.271538540, 3
  %scevgep15 = getelementptr i8, ptr %arg.equations.4, i64 %0
  %.332 = load i64, ptr %scevgep15, align 8
  %.358 = getelementptr double, ptr %arg.g.4, i64 %.332
  %.359 = load double, ptr %.358, align 8
  %scevgep14 = getelementptr i8, ptr %arg.target.4, i64 %0
  %.389 = load double, ptr %scevgep14, align 8
  %.390 = fsub double %.359, %.389
  %scevgep13 = getelementptr i8, ptr %arg.missed.4, i64 %0
  store double %.390, ptr %scevgep13, align 8
  %.451 = tail call double @llvm.fabs.f64(double %.390)
  %.12.i = fcmp ogt double %.451, %most.3.0542
  %.13.i = select i1 %.12.i, double %.451, double %most.3.0542
  %.453 = fadd double %total.3.0543, %.451
  %.278 = add nuw nsw i64 %.271538540, 1
  %exitcond.not = icmp eq i64 %arg.equations.5.0, %.278
  br i1 %exitcond.not, label %B306.endif, label %B130.backedge

B362.backedge:                                    ; preds = %B362.backedge.preheader, %B362.backedge
  %total.4.0553 = phi double [ %.829, %B362.backedge ], [ %total.3.0.lcssa, %B362.backedge.preheader ]
  %most.4.0552 = phi double [ %.13.i4, %B362.backedge ], [ %most.3.0.lcssa, %B362.backedge.preheader ]
  %.645548550 = phi i64 [ %.652, %B362.backedge ], [ 0, %B362.backedge.preheader ]
  %1 = shl i64 %.645548550, 3
  %scevgep9 = getelementptr i8, ptr %arg.others.4, i64 %1
  %.706 = load i64, ptr %scevgep9, align 8
  %.732 = getelementptr double, ptr %arg.g.4, i64 %.706
  %.733 = load double, ptr %.732, align 8
  %2 = add i64 %.645548550, %.164
  %.749 = icmp slt i64 %2, 0
  %3 = select i1 %.749, i64 %8, i64 0
  %scevgep11 = getelementptr i8, ptr %scevgep10, i64 %3
  %scevgep12 = getelementptr i8, ptr %scevgep11, i64 %1
  %.765 = load double, ptr %scevgep12, align 8
  %.766 = fsub double %.733, %.765
  %scevgep8 = getelementptr i8, ptr %arg.slack.4, i64 %1
  store double %.766, ptr %scevgep8, align 8
  %.827 = tail call double @llvm.fabs.f64(double %.766)
  %.12.i3 = fcmp ogt double %.827, %most.4.0552
  %.13.i4 = select i1 %.12.i3, double %.827, double %most.4.0552
  %.829 = fadd double %total.4.0553, %.827
  %.652 = add nuw nsw i64 %.645548550, 1
  %exitcond572.not = icmp eq i64 %arg.others.5.0, %.652
  br i1 %exitcond572.not, label %B544.endif, label %B362.backedge

B612:                                             ; preds = %B544.endif, %B922
  %product.5.0565 = phi double [ %product.6.2, %B922 ], [ 1.000000e+00, %B544.endif ]
  %logs.3.0564 = phi double [ %logs.4.2, %B922 ], [ 0.000000e+00, %B544.endif ]
  %.1029559561 = phi i64 [ %.1036, %B922 ], [ 0, %B544.endif ]
  %.1036 = add nuw nsw i64 %.1029559561, 1
  %4 = shl i64 %.1029559561, 3
  %scevgep7 = getelementptr i8, ptr %arg.low.4, i64 %4
  %.1098 = load double, ptr %scevgep7, align 8
  %.1099 = fcmp ogt double %.1098, -1.000000e+300
  br i1 %.1099, label %B678, label %B700.endif

B678:                                             ; preds = %B612
  %scevgep6 = getelementptr i8, ptr %arg.v.4, i64 %4
  %.1131 = load double, ptr %scevgep6, align 8
  %.1163 = fsub double %.1131, %.1098
  %.1165 = fmul double %product.5.0565, %.1163
  %.1174 = fcmp olt double %.1165, 1.000000e-100
  br i1 %.1174, label %B728, label %B700.endif

B728:                                             ; preds = %B700.endif, %B678
  %product.9.1530 = phi double [ %product.9.1529, %B700.endif ], [ %.1165, %B678 ]
  %.1193 = tail call double @llvm.log.f64(double %product.9.1530)
  %.1197 = fadd double %logs.3.0564, %.1193
  br label %B768

B768:                                             ; preds = %B700.endif, %B728
  %logs.5.2 = phi double [ %.1197, %B728 ], [ %logs.3.0564, %B700.endif ]
  %product.8.2 = phi double [ 1.000000e+00, %B728 ], [ %product.9.1529, %B700.endif ]
  %scevgep = getelementptr i8, ptr %arg.high.4, i64 %4
  %.1243 = load double, ptr %scevgep, align 8
  %.1244 = fcmp olt double %.1243, 1.000000e+300
  br i1 %.1244, label %B792, label %B832

B792:                                             ; preds = %B768
  %scevgep5 = getelementptr i8, ptr %arg.v.4, i64 %4
  %.1307 = load double, ptr %scevgep5, align 8
  %.1310 = fsub double %.1243, %.1307
  %.1312 = fmul double %product.8.2, %.1310
  br label %B832

B832:                                             ; preds = %B792, %B768
  %product.7.1 = phi double [ %.1312, %B792 ], [ %product.8.2, %B768 ]
  %.1323 = fcmp olt double %product.7.1, 1.000000e-100
  %.1339 = fcmp ogt double %product.7.1, 1.000000e+100
  %or.cond = or i1 %.1323, %.1339
  br i1 %or.cond, label %B882, label %B922

B882:                                             ; preds = %B832
  %.1342 = tail call double @llvm.log.f64(double %product.7.1)
  %.1346 = fadd double %logs.5.2, %.1342
  br label %B922

B922:                                             ; preds = %B882, %B832
  %logs.4.2 = phi double [ %.1346, %B882 ], [ %logs.5.2, %B832 ]
  %product.6.2 = phi double [ 1.000000e+00, %B882 ], [ %product.7.1, %B832 ]
  %exitcond573.not = icmp eq i64 %arg.v.5.0, %.1036
  br i1 %exitcond573.not, label %B924.loopexit, label %B612

common.ret:                                       ; preds = %B544.endif, %B924.loopexit
  %logs.3.0.lcssa = phi double [ 0.000000e+00, %B544.endif ], [ %6, %B924.loopexit ]
  store double %total.4.0.lcssa, ptr %arg.out.4, align 8
  %.1458 = getelementptr i8, ptr %arg.out.4, i64 8
  store double %most.4.0.lcssa, ptr %.1458, align 8
  %.1490 = getelementptr i8, ptr %arg.out.4, i64 16
  store double %logs.3.0.lcssa, ptr %.1490, align 8
  store ptr null, ptr %retptr, align 8
  ret i32 0

B924.loopexit:                                    ; preds = %B922
  %5 = tail call double @llvm.log.f64(double %product.6.2)
  %6 = fadd double %logs.4.2, %5
  br label %common.ret

B306.endif:                                       ; preds = %B130.backedge, %B0.endif
  %most.3.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %.13.i, %B130.backedge ]
  %total.3.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %.453, %B130.backedge ]
  %.639549.not = icmp slt i64 %arg.others.5.0, 1
  br i1 %.639549.not, label %B544.endif, label %B362.backedge.preheader

B362.backedge.preheader:                          ; preds = %B306.endif
  %7 = shl i64 %.164, 3
  %scevgep10 = getelementptr i8, ptr %arg.v.4, i64 %7
  %8 = shl i64 %arg.v.5.0, 3
  br label %B362.backedge

B544.endif:                                       ; preds = %B362.backedge, %B306.endif
  %most.4.0.lcssa = phi double [ %most.3.0.lcssa, %B306.endif ], [ %.13.i4, %B362.backedge ]
  %total.4.0.lcssa = phi double [ %total.3.0.lcssa, %B306.endif ], [ %.829, %B362.backedge ]
  %.1023560.not = icmp slt i64 %arg.v.5.0, 1
  br i1 %.1023560.not, label %common.ret, label %B612

B700.endif:                                       ; preds = %B678, %B612
  %product.9.1529 = phi double [ %.1165, %B678 ], [ %product.5.0565, %B612 ]
  %.1190 = fcmp ogt double %product.9.1529, 1.000000e+100
  br i1 %.1190, label %B728, label %B768
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.log.f64(double) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.conditions(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.slope.0, ptr readnone captures(none) %arg.slope.1, i64 %arg.slope.2, i64 %arg.slope.3, ptr readonly captures(none) %arg.slope.4, i64 %arg.slope.5.0, i64 %arg.slope.6.0, ptr readnone captures(none) %arg.v.0, ptr readnone captures(none) %arg.v.1, i64 %arg.v.2, i64 %arg.v.3, ptr readonly captures(none) %arg.v.4, i64 %arg.v.5.0, i64 %arg.v.6.0, ptr readnone captures(none) %arg.low.0, ptr readnone captures(none) %arg.low.1, i64 %arg.low.2, i64 %arg.low.3, ptr readonly captures(none) %arg.low.4, i64 %arg.low.5.0, i64 %arg.low.6.0, ptr readnone captures(none) %arg.high.0, ptr readnone captures(none) %arg.high.1, i64 %arg.high.2, i64 %arg.high.3, ptr readonly captures(none) %arg.high.4, i64 %arg.high.5.0, i64 %arg.high.6.0, ptr readnone captures(none) %arg.below.0, ptr readnone captures(none) %arg.below.1, i64 %arg.below.2, i64 %arg.below.3, ptr readonly captures(none) %arg.below.4, i64 %arg.below.5.0, i64 %arg.below.6.0, ptr readnone captures(none) %arg.above.0, ptr readnone captures(none) %arg.above.1, i64 %arg.above.2, i64 %arg.above.3, ptr readonly captures(none) %arg.above.4, i64 %arg.above.5.0, i64 %arg.above.6.0, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr writeonly captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.6.0) local_unnamed_addr #0 {
B0.endif:
  %.238380.not = icmp slt i64 %arg.v.5.0, 1
  br i1 %.238380.not, label %common.ret, label %B78.endif

B380:                                             ; preds = %B264.endif, %B78.endif
  %least.5.1 = phi double [ %least.3.0386, %B78.endif ], [ %.13.i22, %B264.endif ]
  %most.5.1 = phi double [ %most.3.0387, %B78.endif ], [ %.13.i26, %B264.endif ]
  %scevgep30 = getelementptr i8, ptr %arg.high.4, i64 %0
  %.731 = load double, ptr %scevgep30, align 8
  %.732 = fcmp olt double %.731, 1.000000e+300
  br i1 %.732, label %B404.endif, label %B520

B520:                                             ; preds = %B404.endif, %B380
  %least.4.1 = phi double [ %least.5.1, %B380 ], [ %.13.i24, %B404.endif ]
  %most.4.1 = phi double [ %most.5.1, %B380 ], [ %.13.i28, %B404.endif ]
  %exitcond.not = icmp eq i64 %arg.v.5.0, %.251
  br i1 %exitcond.not, label %common.ret, label %B78.endif

common.ret:                                       ; preds = %B520, %B0.endif
  %off.2.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %.13.i, %B520 ]
  %total.2.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %.418, %B520 ]
  %held.2.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %.488, %B520 ]
  %least.3.0.lcssa = phi double [ 1.000000e+300, %B0.endif ], [ %least.4.1, %B520 ]
  %most.3.0.lcssa = phi double [ -1.000000e+300, %B0.endif ], [ %most.4.1, %B520 ]
  %.965 = fcmp olt double %total.2.0.lcssa, 1.000000e+300
  %"$phi540.0.2.0" = select i1 %.965, double %off.2.0.lcssa, double %total.2.0.lcssa
  store double %"$phi540.0.2.0", ptr %arg.out.4, align 8
  %.1046 = getelementptr i8, ptr %arg.out.4, i64 8
  store double %held.2.0.lcssa, ptr %.1046, align 8
  %.1079 = getelementptr i8, ptr %arg.out.4, i64 16
  store double %least.3.0.lcssa, ptr %.1079, align 8
  %.1112 = getelementptr i8, ptr %arg.out.4, i64 24
  store double %most.3.0.lcssa, ptr %.1112, align 8
  store ptr null, ptr %retptr, align 8
  ret i32 0

B78.endif:                                        ; preds = %B0.endif, %B520
  %most.3.0387 = phi double [ %most.4.1, %B520 ], [ -1.000000e+300, %B0.endif ]
  %least.3.0386 = phi double [ %least.4.1, %B520 ], [ 1.000000e+300, %B0.endif ]
  %held.2.0385 = phi double [ %.488, %B520 ], [ 0.000000e+00, %B0.endif ]
  %total.2.0384 = phi double [ %.418, %B520 ], [ 0.000000e+00, %B0.endif ]
  %off.2.0383 = phi double [ %.13.i, %B520 ], [ 0.000000e+00, %B0.endif ]
  %.244375381 = phi i64 [ %.251, %B520 ], [ 0, %B0.endif ]
  %.251 = add nuw nsw i64 %.244375381, 1
  %0 = shl i64 %.244375381, 3
  %scevgep34 = getelementptr i8, ptr %arg.slope.4, i64 %0
  %.317 = load double, ptr %scevgep34, align 8
  %scevgep33 = getelementptr i8, ptr %arg.below.4, i64 %0
  %.348 = load double, ptr %scevgep33, align 8
  %.349 = fsub double %.317, %.348
  %scevgep32 = getelementptr i8, ptr %arg.above.4, i64 %0
  %.380 = load double, ptr %scevgep32, align 8
  %.381 = fadd double %.349, %.380
  %.382 = tail call double @llvm.fabs.f64(double %.381)
  %.12.i = fcmp ogt double %.382, %off.2.0383
  %.13.i = select i1 %.12.i, double %.382, double %off.2.0383
  %.418 = fadd double %total.2.0384, %.382
  %.486 = fadd double %.348, %.380
  %.488 = fadd double %held.2.0385, %.486
  %scevgep31 = getelementptr i8, ptr %arg.low.4, i64 %0
  %.524 = load double, ptr %scevgep31, align 8
  %.525 = fcmp ogt double %.524, -1.000000e+300
  br i1 %.525, label %B264.endif, label %B380

B264.endif:                                       ; preds = %B78.endif
  %scevgep29 = getelementptr i8, ptr %arg.v.4, i64 %0
  %.557 = load double, ptr %scevgep29, align 8
  %.589 = fsub double %.557, %.524
  %.621 = fmul double %.348, %.589
  %.12.i21 = fcmp olt double %.621, %least.3.0386
  %.13.i22 = select i1 %.12.i21, double %.621, double %least.3.0386
  %.12.i25 = fcmp ogt double %.621, %most.3.0387
  %.13.i26 = select i1 %.12.i25, double %.621, double %most.3.0387
  br label %B380

B404.endif:                                       ; preds = %B380
  %scevgep = getelementptr i8, ptr %arg.v.4, i64 %0
  %.795 = load double, ptr %scevgep, align 8
  %.796 = fsub double %.731, %.795
  %.830 = fmul double %.380, %.796
  %.12.i23 = fcmp olt double %.830, %least.5.1
  %.13.i24 = select i1 %.12.i23, double %.830, double %least.5.1
  %.12.i27 = fcmp ogt double %.830, %most.5.1
  %.13.i28 = select i1 %.12.i27, double %.830, double %most.5.1
  br label %B520
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef i32 @loops.stiffen(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.v.0, ptr readnone captures(none) %arg.v.1, i64 %arg.v.2, i64 %arg.v.3, ptr readonly captures(none) %arg.v.4, i64 %arg.v.5.0, i64 %arg.v.6.0, ptr readnone captures(none) %arg.low.0, ptr readnone captures(none) %arg.low.1, i64 %arg.low.2, i64 %arg.low.3, ptr readonly captures(none) %arg.low.4, i64 %arg.low.5.0, i64 %arg.low.6.0, ptr readnone captures(none) %arg.high.0, ptr readnone captures(none) %arg.high.1, i64 %arg.high.2, i64 %arg.high.3, ptr readonly captures(none) %arg.high.4, i64 %arg.high.5.0, i64 %arg.high.6.0, ptr readnone captures(none) %arg.below.0, ptr readnone captures(none) %arg.below.1, i64 %arg.below.2, i64 %arg.below.3, ptr readonly captures(none) %arg.below.4, i64 %arg.below.5.0, i64 %arg.below.6.0, ptr readnone captures(none) %arg.above.0, ptr readnone captures(none) %arg.above.1, i64 %arg.above.2, i64 %arg.above.3, ptr readonly captures(none) %arg.above.4, i64 %arg.above.5.0, i64 %arg.above.6.0, ptr readnone captures(none) %arg.slope.0, ptr readnone captures(none) %arg.slope.1, i64 %arg.slope.2, i64 %arg.slope.3, ptr readonly captures(none) %arg.slope.4, i64 %arg.slope.5.0, i64 %arg.slope.6.0, double %arg.mu, ptr readnone captures(none) %arg.stiff.0, ptr readnone captures(none) %arg.stiff.1, i64 %arg.stiff.2, i64 %arg.stiff.3, ptr writeonly captures(none) %arg.stiff.4, i64 %arg.stiff.5.0, i64 %arg.stiff.6.0, ptr readnone captures(none) %arg.rest.0, ptr readnone captures(none) %arg.rest.1, i64 %arg.rest.2, i64 %arg.rest.3, ptr writeonly captures(none) %arg.rest.4, i64 %arg.rest.5.0, i64 %arg.rest.6.0) local_unnamed_addr #0 {
B0.endif:
  %.210224.not = icmp slt i64 %arg.v.5.0, 1
  br i1 %.210224.not, label %B232, label %B62.preheader

B62.preheader:                                    ; preds = %B0.endif
  %min.iters.check = icmp samesign ult i64 %arg.v.5.0, 4
  br i1 %min.iters.check, label %B62.preheader37, label %vector.memcheck

vector.memcheck:                                  ; preds = %B62.preheader
  %0 = ptrtoint ptr %arg.rest.4 to i64
  %1 = ptrtoint ptr %arg.stiff.4 to i64
  %2 = ptrtoint ptr %arg.v.4 to i64
  %3 = ptrtoint ptr %arg.low.4 to i64
  %4 = ptrtoint ptr %arg.high.4 to i64
  %5 = ptrtoint ptr %arg.below.4 to i64
  %6 = ptrtoint ptr %arg.above.4 to i64
  %7 = ptrtoint ptr %arg.slope.4 to i64
  %8 = sub i64 %0, %1
  %diff.check = icmp ult i64 %8, 16
  %9 = sub i64 %1, %2
  %diff.check4 = icmp ult i64 %9, 16
  %conflict.rdx = or i1 %diff.check4, %diff.check
  %10 = sub i64 %1, %3
  %diff.check6 = icmp ult i64 %10, 16
  %conflict.rdx7 = or i1 %diff.check6, %conflict.rdx
  %11 = sub i64 %1, %4
  %diff.check9 = icmp ult i64 %11, 16
  %conflict.rdx10 = or i1 %diff.check9, %conflict.rdx7
  %12 = sub i64 %1, %5
  %diff.check12 = icmp ult i64 %12, 16
  %conflict.rdx13 = or i1 %diff.check12, %conflict.rdx10
  %13 = sub i64 %1, %6
  %diff.check15 = icmp ult i64 %13, 16
  %conflict.rdx16 = or i1 %diff.check15, %conflict.rdx13
  %14 = sub i64 %7, %1
  %diff.check18 = icmp ult i64 %14, 16
  %conflict.rdx19 = or i1 %diff.check18, %conflict.rdx16
  %15 = sub i64 %0, %2
  %diff.check20 = icmp ult i64 %15, 16
  %conflict.rdx21 = or i1 %diff.check20, %conflict.rdx19
  %16 = sub i64 %0, %3
  %diff.check22 = icmp ult i64 %16, 16
  %conflict.rdx23 = or i1 %diff.check22, %conflict.rdx21
  %17 = sub i64 %0, %4
  %diff.check24 = icmp ult i64 %17, 16
  %conflict.rdx25 = or i1 %diff.check24, %conflict.rdx23
  %18 = sub i64 %0, %5
  %diff.check26 = icmp ult i64 %18, 16
  %conflict.rdx27 = or i1 %diff.check26, %conflict.rdx25
  %19 = sub i64 %0, %6
  %diff.check28 = icmp ult i64 %19, 16
  %conflict.rdx29 = or i1 %diff.check28, %conflict.rdx27
  %20 = sub i64 %0, %7
  %diff.check30 = icmp ult i64 %20, 16
  %conflict.rdx31 = or i1 %diff.check30, %conflict.rdx29
  br i1 %conflict.rdx31, label %B62.preheader37, label %vector.ph

vector.ph:                                        ; preds = %vector.memcheck
  %n.vec = and i64 %arg.v.5.0, 9223372036854775806
  %broadcast.splatinsert = insertelement <2 x double> poison, double %arg.mu, i64 0
  %broadcast.splat = shufflevector <2 x double> %broadcast.splatinsert, <2 x double> poison, <2 x i32> zeroinitializer
  br label %vector.body

vector.body:                                      ; preds = %vector.body, %vector.ph
  %index = phi i64 [ 0, %vector.ph ], [ %index.next, %vector.body ]
  %21 = shl i64 %index, 3
  %scevgep60 = getelementptr i8, ptr %arg.v.4, i64 %21
  %wide.load = load <2 x double>, ptr %scevgep60, align 8
  %scevgep59 = getelementptr i8, ptr %arg.low.4, i64 %21
  %wide.load32 = load <2 x double>, ptr %scevgep59, align 8
  %22 = fsub <2 x double> %wide.load, %wide.load32
  %scevgep58 = getelementptr i8, ptr %arg.high.4, i64 %21
  %wide.load33 = load <2 x double>, ptr %scevgep58, align 8
  %23 = fsub <2 x double> %wide.load33, %wide.load
  %scevgep57 = getelementptr i8, ptr %arg.below.4, i64 %21
  %wide.load34 = load <2 x double>, ptr %scevgep57, align 8
  %24 = fdiv <2 x double> %wide.load34, %22
  %scevgep56 = getelementptr i8, ptr %arg.above.4, i64 %21
  %wide.load35 = load <2 x double>, ptr %scevgep56, align 8
  %25 = fdiv <2 x double> %wide.load35, %23
  %26 = fadd <2 x double> %24, %25
  %scevgep55 = getelementptr i8, ptr %arg.stiff.4, i64 %21
  store <2 x double> %26, ptr %scevgep55, align 8
  %scevgep54 = getelementptr i8, ptr %arg.slope.4, i64 %21
  %wide.load36 = load <2 x double>, ptr %scevgep54, align 8
  %27 = fdiv <2 x double> %broadcast.splat, %22
  %28 = fsub <2 x double> %wide.load36, %27
  %29 = fdiv <2 x double> %broadcast.splat, %23
  %30 = fadd <2 x double> %29, %28
  %scevgep53 = getelementptr i8, ptr %arg.rest.4, i64 %21
  store <2 x double> %30, ptr %scevgep53, align 8
  %index.next = add nuw nsw i64 %index, 2
  %31 = icmp eq i64 %n.vec, %index.next
  br i1 %31, label %middle.block, label %vector.body, !llvm.loop !6

middle.block:                                     ; preds = %vector.body
  %cmp.n = icmp eq i64 %arg.v.5.0, %n.vec
  br i1 %cmp.n, label %B232, label %B62.preheader37

B62.preheader37:                                  ; preds = %middle.block, %vector.memcheck, %B62.preheader
  %.216223225.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %B62.preheader ], [ %n.vec, %middle.block ]
  %32 = shl i64 %.216223225.ph, 3
  %scevgep = getelementptr i8, ptr %arg.rest.4, i64 %32
  %scevgep39 = getelementptr i8, ptr %arg.slope.4, i64 %32
  %scevgep41 = getelementptr i8, ptr %arg.stiff.4, i64 %32
  %scevgep43 = getelementptr i8, ptr %arg.above.4, i64 %32
  %scevgep45 = getelementptr i8, ptr %arg.below.4, i64 %32
  %scevgep47 = getelementptr i8, ptr %arg.high.4, i64 %32
  %scevgep49 = getelementptr i8, ptr %arg.low.4, i64 %32
  %scevgep51 = getelementptr i8, ptr %arg.v.4, i64 %32
  %33 = sub nsw i64 %arg.v.5.0, %.216223225.ph
  br label %B62

B62:                                              ; preds = %B62, %B62.preheader37
  %lsr.iv = phi i64 [ 0, %B62.preheader37 ], [ %lsr.iv.next, %B62 ]
  %34 = shl i64 %lsr.iv, 3
  %scevgep52 = getelementptr i8, ptr %scevgep51, i64 %34
  %.277 = load double, ptr %scevgep52, align 8
  %scevgep50 = getelementptr i8, ptr %scevgep49, i64 %34
  %.307 = load double, ptr %scevgep50, align 8
  %.308 = fsub double %.277, %.307
  %scevgep48 = getelementptr i8, ptr %scevgep47, i64 %34
  %.338 = load double, ptr %scevgep48, align 8
  %.369 = fsub double %.338, %.277
  %scevgep46 = getelementptr i8, ptr %scevgep45, i64 %34
  %.399 = load double, ptr %scevgep46, align 8
  %.403 = fdiv double %.399, %.308
  %scevgep44 = getelementptr i8, ptr %scevgep43, i64 %34
  %.433 = load double, ptr %scevgep44, align 8
  %.437 = fdiv double %.433, %.369
  %.438 = fadd double %.403, %.437
  %scevgep42 = getelementptr i8, ptr %scevgep41, i64 %34
  store double %.438, ptr %scevgep42, align 8
  %scevgep40 = getelementptr i8, ptr %scevgep39, i64 %34
  %.498 = load double, ptr %scevgep40, align 8
  %.503 = fdiv double %arg.mu, %.308
  %.504 = fsub double %.498, %.503
  %.509 = fdiv double %arg.mu, %.369
  %.510 = fadd double %.509, %.504
  %scevgep38 = getelementptr i8, ptr %scevgep, i64 %34
  store double %.510, ptr %scevgep38, align 8
  %lsr.iv.next = add i64 %lsr.iv, 1
  %exitcond.not = icmp eq i64 %33, %lsr.iv.next
  br i1 %exitcond.not, label %B232, label %B62, !llvm.loop !7

B232:                                             ; preds = %B62, %middle.block, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.steer(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.v.0, ptr readnone captures(none) %arg.v.1, i64 %arg.v.2, i64 %arg.v.3, ptr readonly captures(none) %arg.v.4, i64 %arg.v.5.0, i64 %arg.v.6.0, ptr readnone captures(none) %arg.low.0, ptr readnone captures(none) %arg.low.1, i64 %arg.low.2, i64 %arg.low.3, ptr readonly captures(none) %arg.low.4, i64 %arg.low.5.0, i64 %arg.low.6.0, ptr readnone captures(none) %arg.high.0, ptr readnone captures(none) %arg.high.1, i64 %arg.high.2, i64 %arg.high.3, ptr readonly captures(none) %arg.high.4, i64 %arg.high.5.0, i64 %arg.high.6.0, ptr readnone captures(none) %arg.below.0, ptr readnone captures(none) %arg.below.1, i64 %arg.below.2, i64 %arg.below.3, ptr readonly captures(none) %arg.below.4, i64 %arg.below.5.0, i64 %arg.below.6.0, ptr readnone captures(none) %arg.above.0, ptr readnone captures(none) %arg.above.1, i64 %arg.above.2, i64 %arg.above.3, ptr readonly captures(none) %arg.above.4, i64 %arg.above.5.0, i64 %arg.above.6.0, ptr readnone captures(none) %arg.dv.0, ptr readnone captures(none) %arg.dv.1, i64 %arg.dv.2, i64 %arg.dv.3, ptr readonly captures(none) %arg.dv.4, i64 %arg.dv.5.0, i64 %arg.dv.6.0, double %arg.mu, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr writeonly captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.6.0) local_unnamed_addr #0 {
B0.endif:
  %.223343.not = icmp slt i64 %arg.v.5.0, 1
  br i1 %.223343.not, label %common.ret, label %B74.endif.endif.endif.endif

B366:                                             ; preds = %B286.endif, %B74.endif.endif.endif.endif
  %of_multiplier.5.1 = phi double [ %of_multiplier.3.0347, %B74.endif.endif.endif.endif ], [ %.13.i, %B286.endif ]
  %scevgep = getelementptr i8, ptr %arg.above.4, i64 %0
  %.744 = load double, ptr %scevgep, align 8
  %.746 = fcmp ogt double %.744, 0.000000e+00
  br i1 %.746, label %B390.endif, label %B470

B470:                                             ; preds = %B390.endif, %B366
  %of_multiplier.4.1 = phi double [ %of_multiplier.5.1, %B366 ], [ %.13.i10, %B390.endif ]
  %exitcond.not = icmp eq i64 %arg.v.5.0, %.236
  br i1 %exitcond.not, label %common.ret, label %B74.endif.endif.endif.endif

common.ret:                                       ; preds = %B470, %B0.endif
  %of_gap.2.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %.19.i, %B470 ]
  %of_multiplier.3.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %of_multiplier.4.1, %B470 ]
  %barrier.2.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %.555, %B470 ]
  store double %of_gap.2.0.lcssa, ptr %arg.out.4, align 8
  %.981 = getelementptr i8, ptr %arg.out.4, i64 8
  store double %of_multiplier.3.0.lcssa, ptr %.981, align 8
  %.1014 = getelementptr i8, ptr %arg.out.4, i64 16
  store double %barrier.2.0.lcssa, ptr %.1014, align 8
  store ptr null, ptr %retptr, align 8
  ret i32 0

B74.endif.endif.endif.endif:                      ; preds = %B0.endif, %B470
  %barrier.2.0348 = phi double [ %.555, %B470 ], [ 0.000000e+00, %B0.endif ]
  %of_multiplier.3.0347 = phi double [ %of_multiplier.4.1, %B470 ], [ 0.000000e+00, %B0.endif ]
  %of_gap.2.0346 = phi double [ %.19.i, %B470 ], [ 0.000000e+00, %B0.endif ]
  %.229340344 = phi i64 [ %.236, %B470 ], [ 0, %B0.endif ]
  %.236 = add nuw nsw i64 %.229340344, 1
  %0 = shl i64 %.229340344, 3
  %scevgep15 = getelementptr i8, ptr %arg.v.4, i64 %0
  %.298 = load double, ptr %scevgep15, align 8
  %scevgep14 = getelementptr i8, ptr %arg.low.4, i64 %0
  %.329 = load double, ptr %scevgep14, align 8
  %.330 = fsub double %.298, %.329
  %scevgep13 = getelementptr i8, ptr %arg.high.4, i64 %0
  %.361 = load double, ptr %scevgep13, align 8
  %.393 = fsub double %.361, %.298
  %scevgep12 = getelementptr i8, ptr %arg.dv.4, i64 %0
  %.430 = load double, ptr %scevgep12, align 8
  %.431 = fneg double %.430
  %.436 = fdiv double %.431, %.330
  %.472 = fdiv double %.430, %.393
  %.16.i = fcmp ogt double %.436, %of_gap.2.0346
  %.17.i = select i1 %.16.i, double %.436, double %of_gap.2.0346
  %.18.i = fcmp ogt double %.472, %.17.i
  %.19.i = select i1 %.18.i, double %.472, double %.17.i
  %.514 = fdiv double %arg.mu, %.393
  %.520 = fdiv double %arg.mu, %.330
  %.521 = fsub double %.514, %.520
  %.553 = fmul double %.430, %.521
  %.555 = fadd double %barrier.2.0348, %.553
  %scevgep11 = getelementptr i8, ptr %arg.below.4, i64 %0
  %.591 = load double, ptr %scevgep11, align 8
  %.593 = fcmp ogt double %.591, 0.000000e+00
  br i1 %.593, label %B286.endif, label %B366

B286.endif:                                       ; preds = %B74.endif.endif.endif.endif
  %.661 = fdiv double %arg.mu, %.591
  %.662 = fsub double %.430, %.661
  %.667 = fdiv double %.662, %.330
  %.671 = fadd double %.667, 1.000000e+00
  %.12.i = fcmp ogt double %.671, %of_multiplier.3.0347
  %.13.i = select i1 %.12.i, double %.671, double %of_multiplier.3.0347
  br label %B366

B390.endif:                                       ; preds = %B366
  %.816 = fdiv double %arg.mu, %.744
  %.817 = fadd double %.430, %.816
  %.822 = fdiv double %.817, %.393
  %.826 = fsub double 1.000000e+00, %.822
  %.12.i9 = fcmp ogt double %.826, %of_multiplier.5.1
  %.13.i10 = select i1 %.12.i9, double %.826, double %of_multiplier.5.1
  br label %B470
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.follow(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.v.0, ptr readnone captures(none) %arg.v.1, i64 %arg.v.2, i64 %arg.v.3, ptr readonly captures(none) %arg.v.4, i64 %arg.v.5.0, i64 %arg.v.6.0, ptr readnone captures(none) %arg.low.0, ptr readnone captures(none) %arg.low.1, i64 %arg.low.2, i64 %arg.low.3, ptr readonly captures(none) %arg.low.4, i64 %arg.low.5.0, i64 %arg.low.6.0, ptr readnone captures(none) %arg.high.0, ptr readnone captures(none) %arg.high.1, i64 %arg.high.2, i64 %arg.high.3, ptr readonly captures(none) %arg.high.4, i64 %arg.high.5.0, i64 %arg.high.6.0, ptr readnone captures(none) %arg.dv.0, ptr readnone captures(none) %arg.dv.1, i64 %arg.dv.2, i64 %arg.dv.3, ptr readonly captures(none) %arg.dv.4, i64 %arg.dv.5.0, i64 %arg.dv.6.0, ptr readnone captures(none) %arg.after.0, ptr readnone captures(none) %arg.after.1, i64 %arg.after.2, i64 %arg.after.3, ptr readonly captures(none) %arg.after.4, i64 %arg.after.5.0, i64 %arg.after.6.0, double %arg.mu, double %arg.length, double %arg.far, ptr readnone captures(none) %arg.below.0, ptr readnone captures(none) %arg.below.1, i64 %arg.below.2, i64 %arg.below.3, ptr captures(none) %arg.below.4, i64 %arg.below.5.0, i64 %arg.below.6.0, ptr readnone captures(none) %arg.above.0, ptr readnone captures(none) %arg.above.1, i64 %arg.above.2, i64 %arg.above.3, ptr captures(none) %arg.above.4, i64 %arg.above.5.0, i64 %arg.above.6.0) local_unnamed_addr #0 {
B0.endif:
  %.203394.not = icmp slt i64 %arg.v.5.0, 1
  br i1 %.203394.not, label %common.ret, label %B64.lr.ph

B64.lr.ph:                                        ; preds = %B0.endif
  %.652 = fmul double %arg.mu, %arg.far
  br label %B64

B64:                                              ; preds = %B626, %B64.lr.ph
  %.209390395 = phi i64 [ 0, %B64.lr.ph ], [ %.216, %B626 ]
  %.216 = add nuw nsw i64 %.209390395, 1
  %0 = shl i64 %.209390395, 3
  %scevgep16 = getelementptr i8, ptr %arg.v.4, i64 %0
  %.274 = load double, ptr %scevgep16, align 8
  %scevgep15 = getelementptr i8, ptr %arg.low.4, i64 %0
  %.305 = load double, ptr %scevgep15, align 8
  %scevgep14 = getelementptr i8, ptr %arg.high.4, i64 %0
  %.337 = load double, ptr %scevgep14, align 8
  %.369 = fsub double %.337, %.274
  %.407 = fcmp ogt double %.305, -1.000000e+300
  br i1 %.407, label %B158.endif.endif.endif.endif.endif.endif, label %B380

B380:                                             ; preds = %B158.endif.endif.endif.endif.endif.endif, %B64
  %.749 = phi double [ %.749.pr, %B158.endif.endif.endif.endif.endif.endif ], [ %.337, %B64 ]
  %.750 = fcmp olt double %.749, 1.000000e+300
  br i1 %.750, label %B404.endif.endif.endif.endif.endif.endif, label %B626

B626:                                             ; preds = %B404.endif.endif.endif.endif.endif.endif, %B380
  %exitcond.not = icmp eq i64 %arg.v.5.0, %.216
  br i1 %exitcond.not, label %common.ret, label %B64

common.ret:                                       ; preds = %B626, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B158.endif.endif.endif.endif.endif.endif:         ; preds = %B64
  %.306 = fsub double %.274, %.305
  %.414 = fdiv double %arg.mu, %.306
  %scevgep13 = getelementptr i8, ptr %arg.below.4, i64 %0
  %.445 = load double, ptr %scevgep13, align 8
  %.450 = fdiv double %.445, %.306
  %scevgep11 = getelementptr i8, ptr %arg.dv.4, i64 %0
  %.483 = load double, ptr %scevgep11, align 8
  %.484 = fmul double %.450, %.483
  %.485 = fsub double %.414, %.484
  %scevgep9 = getelementptr i8, ptr %arg.after.4, i64 %0
  %.516 = load double, ptr %scevgep9, align 8
  %.548 = fsub double %.516, %.305
  %.611 = fsub double %.485, %.445
  %.613 = fmul double %arg.length, %.611
  %.614 = fadd double %.445, %.613
  %.616 = fmul double %arg.far, %.548
  %.621 = fdiv double %arg.mu, %.616
  %.12.i = fcmp ogt double %.621, %.614
  %.13.i = select i1 %.12.i, double %.621, double %.614
  %.656 = fdiv double %.652, %.548
  %.12.i3 = fcmp olt double %.656, %.13.i
  %.13.i4 = select i1 %.12.i3, double %.656, double %.13.i
  store double %.13.i4, ptr %scevgep13, align 8
  %.749.pr = load double, ptr %scevgep14, align 8
  br label %B380

B404.endif.endif.endif.endif.endif.endif:         ; preds = %B380
  %.757 = fdiv double %arg.mu, %.369
  %scevgep12 = getelementptr i8, ptr %arg.above.4, i64 %0
  %.788 = load double, ptr %scevgep12, align 8
  %.793 = fdiv double %.788, %.369
  %scevgep10 = getelementptr i8, ptr %arg.dv.4, i64 %0
  %.826 = load double, ptr %scevgep10, align 8
  %.827 = fmul double %.793, %.826
  %.828 = fadd double %.757, %.827
  %scevgep = getelementptr i8, ptr %arg.after.4, i64 %0
  %.890 = load double, ptr %scevgep, align 8
  %.891 = fsub double %.749, %.890
  %.954 = fsub double %.828, %.788
  %.956 = fmul double %arg.length, %.954
  %.957 = fadd double %.788, %.956
  %.959 = fmul double %arg.far, %.891
  %.964 = fdiv double %arg.mu, %.959
  %.12.i5 = fcmp ogt double %.964, %.957
  %.13.i6 = select i1 %.12.i5, double %.964, double %.957
  %.999 = fdiv double %.652, %.891
  %.12.i7 = fcmp olt double %.999, %.13.i6
  %.13.i8 = select i1 %.12.i7, double %.999, double %.13.i6
  store double %.13.i8, ptr %scevgep12, align 8
  br label %B626
}

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #1 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }

!0 = distinct !{!0, !1, !2}
!1 = !{!"llvm.loop.isvectorized", i32 1}
!2 = !{!"llvm.loop.unroll.runtime.disable"}
!3 = distinct !{!3, !4}
!4 = !{!"llvm.loop.unroll.disable"}
!5 = distinct !{!5, !1}
!6 = distinct !{!6, !1, !2}
!7 = distinct !{!7, !1}
