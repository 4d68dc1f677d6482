testsuite A for B {
 test x { input { a: <1, 2 3>; b: c; d <>; } expect { x: <1,>; } foo { } } tst y { } }