component Rich extends Needy(1, 2, 3, 4) { }
