component Poor extends Needy(1) { }
