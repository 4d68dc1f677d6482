component Again extends Needy(1, 2, a = 3) { }
