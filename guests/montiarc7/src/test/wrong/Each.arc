component Each {
  port sync in List<String> list, sync out int b;
  int n = 0;
  compute { for (String each : list) { n++; } b = n; }
}
