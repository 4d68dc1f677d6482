component Begun {
  port in int a, out int b;
  compute { for (int i = a; i < 3; i++) { b = i; } }
}
