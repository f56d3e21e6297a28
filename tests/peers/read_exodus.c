/* Prints what Exodus' own library reads of each file: blocks with their number, type and name, and side sets with the
 * mean of the corners of each side. usage: read_exodus FILE... */
#include <exodusII.h>
#include <stdio.h>
#include <stdlib.h>

static void die(const char *what) {
  fprintf(stderr, "%s\n", what);
  exit(1);
}

static void check(int code, const char *what) {
  if (code != 0) die(what);
}

/* Of the positions x, dim rows of n, the mean of a side's corners. */
static void print_side(const double *x, int dim, int n, const int *nodes, int corners) {
  for (int d = 0; d < dim; ++d) {
    double sum = 0;
    for (int c = 0; c < corners; ++c) sum += x[d * n + nodes[c] - 1];
    printf(" %.17g", sum / corners);
  }
}

static void print_side_set(int file, int id, const char *name, const double *x, int dim, int n) {
  int sides, factors, length;
  check(ex_get_side_set_param(file, id, &sides, &factors), "ex_get_side_set_param");
  check(ex_get_side_set_node_list_len(file, id, &length), "ex_get_side_set_node_list_len");
  int *counts = malloc(sides * sizeof(int)), *nodes = malloc(length * sizeof(int)), *at = nodes;
  check(ex_get_side_set_node_list(file, id, counts, nodes), "ex_get_side_set_node_list");
  printf("sides %s", name);
  for (int s = 0; s < sides; at += counts[s++]) print_side(x, dim, n, at, 2 * (dim - 1));
  printf("\n");
  free(counts);
  free(nodes);
}

static void print_blocks(int file, int count) {
  int *ids = malloc(count * sizeof(int)), elements, nodes, attributes;
  char type[MAX_STR_LENGTH + 1], name[MAX_STR_LENGTH + 1];
  check(ex_get_elem_blk_ids(file, ids), "ex_get_elem_blk_ids");
  for (int b = 0; b < count; ++b) {
    check(ex_get_elem_block(file, ids[b], type, &elements, &nodes, &attributes), "ex_get_elem_block");
    check(ex_get_name(file, EX_ELEM_BLOCK, ids[b], name), "ex_get_name");
    int *list = malloc(elements * nodes * sizeof(int));
    check(ex_get_elem_conn(file, ids[b], list), "ex_get_elem_conn");
    printf("block %s %s %d\n", name, type, elements);
    free(list);
  }
  free(ids);
}

static void print_file(const char *path) {
  int eight = 8, as_stored = 0, dim, n, elements, blocks, node_sets, side_sets;
  float version;
  char title[MAX_LINE_LENGTH + 1], name[MAX_STR_LENGTH + 1];
  int file = ex_open(path, EX_READ, &eight, &as_stored, &version);
  if (file < 0) die("ex_open");
  check(ex_get_init(file, title, &dim, &n, &elements, &blocks, &node_sets, &side_sets), "ex_get_init");
  printf("file %s %d %d\n", path, dim, elements);
  double *x = malloc(3 * n * sizeof(double));
  check(ex_get_coord(file, x, x + n, dim == 3 ? x + 2 * n : NULL), "ex_get_coord");
  print_blocks(file, blocks);
  int *ids = malloc(side_sets * sizeof(int));
  check(ex_get_side_set_ids(file, ids), "ex_get_side_set_ids");
  for (int s = 0; s < side_sets; ++s) {
    check(ex_get_name(file, EX_SIDE_SET, ids[s], name), "ex_get_name");
    print_side_set(file, ids[s], name, x, dim, n);
  }
  free(ids);
  free(x);
  check(ex_close(file), "ex_close");
}

int main(int argc, char **argv) {
  ex_opts(EX_VERBOSE);
  for (int k = 1; k < argc; ++k) print_file(argv[k]);
  return 0;
}
